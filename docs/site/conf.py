# SPDX-License-Identifier: Apache-2.0
"""The guide: Markdown in docs/, pages by Sphinx with furo, everything local. Built by ci/docs."""
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

project = "polhode"
release = re.search(r"project\(polhode VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
copyright = "the authors of polhode, Apache-2.0"
extensions = ["myst_parser"]
exclude_patterns = ["site", "*.ipynb"]
myst_heading_anchors = 4
myst_enable_extensions = ["dollarmath", "html_image"]
html_theme = "furo"
html_title = f"polhode {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["theme.js", "catalogue.js"]
html_copy_source = False
html_show_sphinx = False
