# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The kinds of shape as JSON names them, in the order of tables."""

KINDS = ("plane", "sphere", "cylinder", "cone")
