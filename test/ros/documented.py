# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""Functions of the documents, as they stand there."""
import os
import re


def documented(source, name):
    """The Python function of this name in docs/ros_api.md, below the folder of the sources."""
    with open(os.path.join(source, "docs", "ros_api.md"), encoding="utf-8") as file:
        blocks = re.findall(r"```python\n(.*?)```", file.read(), re.S)
    names = {}
    exec([block for block in blocks if "def %s(" % name in block][0], names)
    return names[name]
