"""The site in which every program of ours runs in the page."""
