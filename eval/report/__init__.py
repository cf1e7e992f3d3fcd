# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""The one command of the evaluation, eval/run: what is measured, what is kept, and what is made of it."""
