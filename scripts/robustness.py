#!/usr/bin/python3
"""How the figures fall when the sensor, the poses or the place get worse: simulated variants, each labelled with the
same parameters. Writes OUT/robustness.md (tables), OUT/robustness.csv and OUT/robustness.png.

A variant that was simulated before is used again: remove OUT/sequences after a change of the simulator."""
import argparse
import csv
import pathlib
import random
import shutil
import subprocess
import sys

COLUMNS = ('PR', 'RR', 'score', 'IoU', 'score delayed', 'PR final', 'RR final', 'score final')
GOALS = {'score': 90.0, 'PR': 99.5}  # at once; below is marked

# A curve: its name, and (value, simulate's options, percent of the scans dropped). Where nothing else is said, poses
# shake by 1 cm and 0.05 degrees and drift by 0.2 %, ranges by 2 cm.
STREET = ['street', '--sensor', 'hdl64']


def curve(name, option, values, usual):
    return name, [(str(value), STREET + ([] if value == usual else [option, str(value)]), 0) for value in values]


CURVES = [
    curve('pose noise, m', '--pose-noise-m', (0, 0.01, 0.03, 0.05), usual=0.01),
    curve('pose noise, degrees', '--pose-noise-deg', (0, 0.05, 0.2, 0.5), usual=0.05),
    curve('drift, %', '--drift-percent', (0.1, 0.2, 0.5, 1), usual=0.2),
    ('rings', [(rings, ['street', '--sensor', sensor], 0)
               for rings, sensor in (('128', 'os1_128'), ('64', 'os1_64'), ('32', 'hdl32'), ('16', 'vlp16'))]),
    curve('scans a second', '--rate-hz', (10, 5), usual=10),
    curve('range noise, m', '--range-noise-m', (0, 0.02, 0.04, 0.06), usual=0.02),
    ('dropped scans, %', [('0', STREET, 0), ('10', STREET, 10)]),
]
PLACES = ('street', 'wood', 'rooms', 'carpark', 'highway')
PATTERNS = {'16 rings': 'vlp16', '32 rings': 'hdl32', '64 rings': 'hdl64', '128 rings': 'os1_128',
            'livox': 'livox', 'mid360': 'mid360'}
CURVES += [(f'pattern, {place}', [(pattern, [place, '--sensor', sensor], 0) for pattern, sensor in PATTERNS.items()])
           for place in PLACES]


def sequence_name(options, dropped, args):
    words = [word.lstrip('-') for word in options] + [f's{args.seed}', f'n{args.scans}']
    return '_'.join(words + ([f'drop{dropped}'] if dropped else [])).replace('.', 'p')  # no file extension


def simulate(options, dropped, args, folder):
    """The sequence, and nothing half made under its name."""
    if folder.exists():
        return
    made = folder.with_suffix('.part')
    shutil.rmtree(made, ignore_errors=True)
    run([args.stillmap, 'simulate', *options[:1], made, *options[1:], '--seed', args.seed, '--scans', args.scans])
    if dropped:
        drop_scans(made, dropped, args.seed)
    made.rename(folder)


def drop_scans(folder, percent, seed):
    """Takes scans away at random, never the first."""
    names = sorted(file.stem for file in (folder / 'velodyne').iterdir())
    gone = set(random.Random(seed).sample(range(1, len(names)), len(names) * percent // 100))
    for kind in ('velodyne', 'labels', 'labels_now'):
        kept = 0
        for k, file in enumerate(sorted((folder / kind).iterdir())):
            if k in gone:
                file.unlink()
            else:
                file.rename(file.with_name(f'{kept:06d}{file.suffix}'))
                kept += 1
    for table in ('poses.txt', 'times.txt'):
        lines = (folder / table).read_text().splitlines(keepends=True)
        (folder / table).write_text(''.join(line for k, line in enumerate(lines) if k not in gone))


def run(words):
    result = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f'robustness.py: {" ".join(map(str, words))}: {result.stderr.strip()}')


def evaluate(sequences, args):
    """Figures by sequence, from one report over all of them."""
    report = args.out / 'report'
    run([args.stillmap, 'evaluate', *sequences, '--methods', 'default', '--brief', '--no-figures', '--out', report,
         *(word for value in args.set for word in ('--set', value))])
    figures = {}
    with open(report / 'scores.csv', newline='', encoding='utf-8') as stream:
        for row in csv.DictReader(stream):
            if row['uncertain'] != 'kept':
                continue
            suffix = '' if row['pass'] == 'at once' else ' ' + row['pass']
            for column, source in (('PR', 'PR (SA)'), ('RR', 'RR (DA, recall)'), ('score', 'score (HA)'), ('IoU', 'IoU')):
                figures.setdefault(row['sequence'], {})[column + suffix] = row[source]
    return figures


def below_goal(column, value):
    return column in GOALS and value != 'not defined' and float(value) < GOALS[column]


def table(name, rows):
    lines = [f'## {name}\n', '| ' + ' | '.join((name, *COLUMNS)) + ' |', '|---' * (len(COLUMNS) + 1) + '|']
    for value, figures in rows:
        cells = [f'**{figures[c]}**' if below_goal(c, figures[c]) else figures[c] for c in COLUMNS]
        lines.append('| ' + ' | '.join((value, *cells)) + ' |')
    return '\n'.join(lines) + '\n'


def draw(results, file):
    import matplotlib  # pylint: disable=import-outside-toplevel  # tables come without it
    matplotlib.use('Agg')
    import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel
    columns = 4
    height = -(-len(results) // columns)
    figure, grid = plt.subplots(height, columns, figsize=(4.2 * columns, 3.2 * height), squeeze=False)
    for axes in grid.flat[len(results):]:
        axes.axis('off')
    for axes, (name, rows) in zip(grid.flat, results.items()):
        for column, colour, style in (('PR', '#2166ac', '-'), ('score', '#d73027', '-'), ('score final', '#d73027', ':')):
            values = [float(figures[column]) if figures[column] != 'not defined' else float('nan') for _, figures in rows]
            axes.plot([value for value, _ in rows], values, color=colour, linestyle=style, marker='o', label=column)
        axes.set_title(name)
        axes.set_ylim(min(70, axes.get_ylim()[0]), 100.5)
        axes.tick_params(axis='x', labelrotation=30)
        axes.grid(alpha=0.3)
    grid[0][0].legend(fontsize='small')
    figure.tight_layout()
    figure.savefig(file, dpi=80, metadata={'Software': None})


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('out', type=pathlib.Path, metavar='OUT')
    parser.add_argument('--stillmap', default='build/devel/lib/stillmap/stillmap', help='the command line of a build')
    parser.add_argument('--seed', type=int, default=23)
    parser.add_argument('--scans', type=int, default=60, help='of each variant')
    parser.add_argument('--only', nargs='+', default=[''], help='curves whose name starts so')
    parser.add_argument('--set', action='append', default=[], help='name=value of a parameter')
    return parser.parse_args()


def main():
    args = parse()
    (args.out / 'sequences').mkdir(parents=True, exist_ok=True)
    curves = [entry for entry in CURVES if entry[0].startswith(tuple(args.only))]
    folders = {}
    for _, variants in curves:
        for _, options, dropped in variants:
            name = sequence_name(options, dropped, args)
            folders[name] = args.out / 'sequences' / name
            simulate(options, dropped, args, folders[name])
    figures = evaluate(folders.values(), args)
    results = {name: [(value, figures[sequence_name(options, dropped, args)]) for value, options, dropped in variants]
               for name, variants in curves}
    text = '\n'.join(table(name, rows) for name, rows in results.items())
    (args.out / 'robustness.md').write_text(text)
    with open(args.out / 'robustness.csv', 'w', newline='', encoding='utf-8') as stream:
        writer = csv.writer(stream)
        writer.writerow(('curve', 'value', *COLUMNS))
        writer.writerows((name, value, *(row[c] for c in COLUMNS)) for name, rows in results.items() for value, row in rows)
    draw(results, args.out / 'robustness.png')
    print(text)


if __name__ == '__main__':
    main()
