"""Sphinx: the API reference from the docstrings of the installed package."""

import tumble

project = "tumble"
release = tumble.__version__
extensions = ["sphinx.ext.autodoc"]
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_type_aliases = {"Vector": "Vector"}
autodoc_default_options = {"members": True, "undoc-members": True, "show-inheritance": True, "inherited-members": "tuple, Exception, OSError"}
add_module_names = False
html_theme = "alabaster"
html_theme_options = {"description": "2D physics in Python, bit for bit", "page_width": "1100px"}
html_show_sphinx = False
html_copy_source = False
