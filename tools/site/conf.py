"""How Sphinx makes the site of the documents that tools/build_site.py lays out."""

project = "Facet & Film"
copyright = "the authors of Facet & Film; measured data and catalogue CC0"
extensions = ["myst_parser"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
exclude_patterns = ["README.md"]
html_theme = "furo"
html_title = "Facet & Film"
html_static_path = ["_static"]
html_extra_path = ["_extra"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {"light_css_variables": {"color-brand-primary": "#8a4b16", "color-brand-content": "#8a4b16"},
                      "dark_css_variables": {"color-brand-primary": "#e8a15f", "color-brand-content": "#e8a15f"}}
