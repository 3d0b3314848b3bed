# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""All extremes, topic by topic."""

import flows
import liquids
import long_runs
import odd_scenes
import scales
import solids
import spheres
import steps

TOPICS = [scales, flows, liquids, spheres, solids, odd_scenes, steps, long_runs]


def all_extremes():
    return [one for topic in TOPICS for one in topic.extremes()]
