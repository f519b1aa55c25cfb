"""From the bytes of a source to its words, with all directives carried out."""
