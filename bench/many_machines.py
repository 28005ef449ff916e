"""Wall time of a blind set over many ranks, from the wall times of campaigns that were run (docs/many_machines.md).

    python3 bench/many_machines.py SET [--campaigns N] [--ranks 16,256,4096]

SET is a folder that `secular blind run` has gone through: the times are those of its case_*/run.json, drawn with
replacement (seed fixed). Rank 0 hands out campaigns one at a time to whoever is free, which takes it HAND_OUT_S for each,
one after the other; a rank waits WAIT_S between two campaigns; SERIAL_S a campaign is what rank 0 does alone (scores).
"""

import argparse
import heapq
import json
import pathlib
import random

HAND_OUT_S = 30e-6  # processor time of rank 0, from 10,000 campaigns without work
WAIT_S = 6e-3  # wall time of the same on a busy machine: both sides look for messages once a millisecond
SERIAL_S = 0.6e-3  # `blind score`, processor time
LARGEST_SET = 9999  # campaigns of one set


def wall_time(times, ranks):
    """Each campaign in turn to the rank that is free first, through rank 0, which serves one at a time."""
    free = [0.0] * ranks
    served = 0.0
    for time in times:
        served = max(served, free[0]) + HAND_OUT_S
        heapq.heapreplace(free, served + WAIT_S + time)
    return max(free)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("set", type=pathlib.Path)
    parser.add_argument("--campaigns", type=int, default=1_000_000)
    parser.add_argument("--ranks", default="16,256,4096")
    options = parser.parse_args()
    measured = [json.loads(file.read_text())["seconds"] for file in sorted(options.set.glob("case_*/run.json"))]
    if not measured:
        parser.error(f"{options.set} holds no case_*/run.json: run `secular blind run {options.set}` before")
    draw = random.Random(1)
    times = [draw.choice(measured) for _ in range(options.campaigns)]
    total = sum(times)
    serial = SERIAL_S * options.campaigns
    print(f"{len(measured)} campaigns of {min(measured):.1f} to {max(measured):.1f} s, mean {sum(measured) / len(measured):.1f} s")
    print("| ranks that work | one queue | efficiency | with scores | sets of 9,999 in turn |")
    print("|---|---|---|---|---|")
    for ranks in map(int, options.ranks.split(",")):
        wall = wall_time(times, ranks)
        sets = sum(wall_time(times[i : i + LARGEST_SET], ranks) for i in range(0, len(times), LARGEST_SET))
        shares = [total / (ranks * w) for w in (wall, wall + serial, sets)]
        print(f"| {ranks} | {wall / 3600:.2f} h | {shares[0]:.3f} | {shares[1]:.3f} | {shares[2]:.3f} |")


if __name__ == "__main__":
    main()
