"""The monitor that is a page in a browser: `BGI_MONITOR=web`.

The program starts a process (`webchild.py`), as it does for a window, and that process is a server
for the page in `page/` and for what crosses between page and program. It needs `websockets`.
"""
