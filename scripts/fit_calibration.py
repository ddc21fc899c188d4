#!/usr/bin/python3
"""Fits the curves of src/core/calibration.cpp: how often points stand, by the reason of their label and their log-odds.

  stillmap evaluate SEQUENCES --methods default --delay 0 --set calibrate_p_static=false --out REPORT
  python3 scripts/fit_calibration.py REPORT/reasons.csv [MORE/reasons.csv ...]

Every sequence counts the same. What was never judged, or decided by its object, gets a constant."""
import argparse
import collections
import csv
import math

WITH_SLOPE = ('mixed evidence', 'supported', 'seen through by earlier scans', 'seen through by later scans')
LATER = 'seen through by later scans'  # of final verdicts only; the other reasons are fitted to those at once
LEAST = 0.015  # beyond it the curves stay flat


def read(paths):
    """{reason: [(log-odds, static, dynamic), ...]}, shares of the sequence's points."""
    sequences = collections.defaultdict(list)
    for path in paths:
        with open(path, newline='') as file:
            for row in csv.DictReader(file):
                wanted = 'final' if row['reason'] == LATER else 'at once'
                if row['pass'] == wanted:
                    sequences[path, row['sequence']].append(row)
    samples = collections.defaultdict(list)
    for rows in sequences.values():
        points = sum(int(row['static']) + int(row['dynamic']) for row in rows)
        for row in rows:
            p = min(max(float(row['p_static from']) + 0.005, LEAST), 1 - LEAST)
            samples[row['reason']].append(
                (math.log(p / (1 - p)), int(row['static']) / points, int(row['dynamic']) / points))
    return samples


def fit(samples, with_slope):
    """Newton's method on the likelihood of a logistic curve."""
    offset, slope = 0.0, 0.0
    total = sum(static + dynamic for _, static, dynamic in samples)
    for _ in range(100):
        g0 = g1 = h00 = h01 = h11 = 0.0
        for log_odds, static, dynamic in samples:
            p = 1 / (1 + math.exp(-(offset + slope * log_odds)))
            error = ((static + dynamic) * p - static) / total
            weight = (static + dynamic) * p * (1 - p) / total
            g0 += error
            h00 += weight
            if with_slope:
                g1 += error * log_odds
                h01 += weight * log_odds
                h11 += weight * log_odds * log_odds
        h00 += 1e-6
        h11 = h11 + 1e-6 if with_slope else 1.0
        determinant = h00 * h11 - h01 * h01
        offset -= (h11 * g0 - h01 * g1) / determinant
        slope -= (h00 * g1 - h01 * g0) / determinant
    return offset, slope


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('reasons', nargs='+', help='reasons.csv of reports')
    samples = read(parser.parse_args().reasons)
    if not samples:
        raise SystemExit('no verdicts with a reason in these files; was --methods default given?')
    for reason in sorted(samples):
        offset, slope = fit(samples[reason], reason in WITH_SLOPE)
        print(f'{{{offset:.2f}F, {slope:.2f}F}},  // {reason}')


if __name__ == '__main__':
    main()
