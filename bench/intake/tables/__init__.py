# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of bench/intake/make_tables.py."""
