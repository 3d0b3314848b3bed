#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""run_extremes.py PROGRAM [--topic NAME] [--name TEXT] [--quick] [--page FILE] [--jobs N]: runs the extremes of this
folder, and says how each ended. Ends with 1 if one did not end as it has to."""
import argparse
import concurrent.futures
import os
import sys

import extreme as extremes
import page
import topics


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--topic", default="", help="only this one")
    parser.add_argument("--name", default="", help="only extremes with this in their names")
    parser.add_argument("--quick", action="store_true", help="without those that take long")
    parser.add_argument("--page", default="", help="file to write a page of them to")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time")
    return parser.parse_args()


def main():
    given = parse()
    chosen = [one for one in topics.all_extremes()
              if given.topic in ("", one.topic) and given.name in one.name and not (given.quick and one.slow)]
    if not chosen:
        sys.exit(f"no extreme of topic '{given.topic}' has '{given.name}' in its name")
    program = os.path.realpath(given.program)
    endings = []
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for one, ending in zip(chosen, pool.map(lambda one: extremes.run(program, one), chosen)):
            endings.append(ending)
            good = extremes.as_expected(one, ending)
            figure = "" if ending.deviation is None else f"{ending.deviation:.3g} (at most {one.bound:g}) "
            print(f"{'ok  ' if good else 'FAIL'} {ending.wall:6.1f} s  {one.topic}: {one.name}: {ending.how} {figure}"
                  f"{ending.message[:300]}" + ("" if good else f"  [expected: {one.ends} '{one.says}']"), flush=True)
    if given.page:
        page.write(given.page, list(zip(chosen, endings)))
    bad = sum(not extremes.as_expected(one, ending) for one, ending in zip(chosen, endings))
    print(f"{len(chosen)} extremes, {bad} not as they have to be")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
