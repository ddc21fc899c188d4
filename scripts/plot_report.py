#!/usr/bin/python3
"""plot_report.py REPORT: draws the figures of a `stillmap evaluate` report and its page, index.html."""
import base64
import collections
import csv
import html
import pathlib
import sys

try:
    import matplotlib
    import numpy as np
except ImportError as error:
    sys.exit(f'plot_report.py: {error}; install python3-matplotlib')
matplotlib.use('Agg')
import matplotlib.pyplot as plt

LOCAL_REGION_M = 12.0  # section 2.1
KEPT, REMOVED_RIGHT, REMOVED_WRONG, MISSED = range(4)
COLOURS = {KEPT: '#9aa3ad', REMOVED_RIGHT: '#1a9850', REMOVED_WRONG: '#d73027', MISSED: '#ff8c00'}
MEANINGS = {KEPT: 'static, kept', REMOVED_RIGHT: 'moving, removed', REMOVED_WRONG: 'static, removed',
            MISSED: 'moving, missed'}
MOVING = '#2166ac'


def read_points(file):
    with open(file, newline='') as stream:
        rows = list(csv.reader(stream))[1:]
    return np.array(rows, dtype=float).reshape(-1, 4)


def centre_of_motion(points):
    """Where a square of 12 m holds the most moving points."""
    moving = points[np.isin(points[:, 3], (REMOVED_RIGHT, MISSED)), :2]
    if len(moving) == 0:
        return points[:, :2].mean(axis=0)
    cells, index = np.unique(np.floor(moving / LOCAL_REGION_M), axis=0, return_inverse=True)
    return moving[index.ravel() == np.bincount(index.ravel()).argmax()].mean(axis=0)


def draw_codes(axes, points, colours, sizes):
    for code in sorted(colours):
        part = points[points[:, 3] == code]
        axes.scatter(part[:, 0], part[:, 1], s=sizes[code], c=colours[code], linewidths=0, rasterized=True)
    axes.set_aspect('equal')
    axes.set_xlabel('x, m')
    axes.set_ylabel('y, m')


def plot_before_after(points, title, file):
    """Before and after, the whole and the local region; seen from above."""
    figure, grid = plt.subplots(2, 2, figsize=(12, 11))
    before = {KEPT: COLOURS[KEPT], REMOVED_WRONG: COLOURS[KEPT], REMOVED_RIGHT: MOVING, MISSED: MOVING}
    centre = centre_of_motion(points)
    reach = np.percentile(np.abs(points[:, :2] - centre).max(axis=1), 97)
    for row, (half, scale) in enumerate(((reach, 1.0), (LOCAL_REGION_M / 2, 6.0))):
        sizes = {KEPT: 0.5 * scale, REMOVED_RIGHT: 1.5 * scale, REMOVED_WRONG: 1.5 * scale, MISSED: 1.5 * scale}
        for axes, colours, name in ((grid[row][0], before, 'before'), (grid[row][1], COLOURS, 'after')):
            draw_codes(axes, points, colours, sizes)
            axes.set_xlim(centre[0] - half, centre[0] + half)
            axes.set_ylim(centre[1] - half, centre[1] + half)
            axes.set_title(name if row == 0 else f'{name}, {LOCAL_REGION_M:.0f} m')
    marks = [plt.Line2D([], [], marker='o', linestyle='', color=MOVING, label='moving (before)')]
    marks += [plt.Line2D([], [], marker='o', linestyle='', color=COLOURS[c], label=MEANINGS[c]) for c in COLOURS]
    figure.legend(handles=marks, loc='lower center', ncol=len(marks))
    figure.suptitle(title)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    save(figure, file)


def grouped(file):
    """Rows of a CSV by sequence, then by (method, pass)."""
    groups = collections.defaultdict(lambda: collections.defaultdict(list))
    with open(file, newline='') as stream:
        for row in csv.DictReader(stream):
            groups[row['sequence']][row['method'], row['pass']].append(row)
    return groups


def numbers(rows, column):
    return [float('nan') if row[column] == 'not defined' else float(row[column]) for row in rows]


def plot_thresholds(curves, sequence, file):
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 5))
    for (method, name), rows in curves.items():
        threshold, pr, rr = (numbers(rows, c) for c in ('removed below p_static', 'PR', 'RR'))
        line, = left.plot(threshold, pr, label=f'{method}, {name}: PR')
        left.plot(threshold, rr, linestyle='--', color=line.get_color(), label=f'{method}, {name}: RR')
        right.plot(rr, pr, label=f'{method}, {name}')
    left.set_xlabel('a point is removed when its p_static is below')
    left.set_ylabel('%')
    right.set_xlabel('RR, %')
    right.set_ylabel('PR, %')
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.legend(fontsize='small')
    figure.suptitle(f'{sequence}: PR and RR against the threshold')
    figure.tight_layout()
    save(figure, file)


def plot_calibration(curves, sequence, file):
    figure, axes = plt.subplots(figsize=(6, 6))
    axes.plot([0, 1], [0, 1], color='black', linewidth=0.8, label='as claimed')
    for (method, name), rows in curves.items():
        error = rows[0]['expected calibration error']
        axes.plot(numbers(rows, 'mean p_static'), numbers(rows, 'truly static share'), marker='o',
                  label=f'{method}, {name} (error {error})')
    axes.set_xlabel('p_static')
    axes.set_ylabel('share that is truly static')
    axes.grid(alpha=0.3)
    axes.legend(fontsize='small')
    axes.set_title(f'{sequence}: calibration')
    figure.tight_layout()
    save(figure, file)


def save(figure, file):
    figure.savefig(file, dpi=80, metadata={'Software': None})
    plt.close(figure)


def draw_figures(report):
    figures = report / 'figures'
    figures.mkdir(exist_ok=True)
    for old in figures.glob('*.png'):
        old.unlink()
    for file in sorted((report / 'points').glob('*.csv')):
        points = read_points(file)
        if len(points) > 0:
            plot_before_after(points, file.stem.replace('.', ': '), figures / f'{file.stem}.png')
    for sequence, curves in grouped(report / 'thresholds.csv').items():
        plot_thresholds(curves, sequence, figures / f'{sequence}_thresholds.png')
    for sequence, curves in grouped(report / 'calibration.csv').items():
        plot_calibration(curves, sequence, figures / f'{sequence}_calibration.png')


def table_html(header, rows):
    lines = [''.join(f'<th>{html.escape(cell)}</th>' for cell in header)]
    lines += [''.join(f'<td>{html.escape(cell)}</td>' for cell in row) for row in rows]
    return '<table>' + ''.join(f'<tr>{line}</tr>' for line in lines) + '</table>'


def markdown_html(text):
    """Headings, paragraphs and tables: all that the report's Markdown has."""
    blocks = []
    for block in text.strip().split('\n\n'):
        if block.startswith('|'):
            rows = [[cell.strip() for cell in line.strip('|').split('|')] for line in block.splitlines()]
            blocks.append(table_html(rows[0], rows[2:]))
        elif block.startswith('#'):
            level = len(block) - len(block.lstrip('#'))
            blocks.append(f'<h{level}>{html.escape(block.lstrip("# "))}</h{level}>')
        else:
            blocks.append(f'<p>{html.escape(block)}</p>')
    return '\n'.join(blocks)


def csv_html(file):
    with open(file, newline='') as stream:
        rows = list(csv.reader(stream))
    return f'<details><summary>{file.name}</summary>{table_html(rows[0], rows[1:])}</details>'


def write_page(report):
    parts = [markdown_html((report / 'tables.md').read_text()), '<h1>Figures</h1>']
    for file in sorted((report / 'figures').glob('*.png')):
        data = base64.b64encode(file.read_bytes()).decode()
        parts.append(f'<h3>{html.escape(file.stem)}</h3><img src="data:image/png;base64,{data}" alt="{file.stem}">')
    parts.append('<h1>All figures as tables</h1>')
    parts += [csv_html(report / f'{name}.csv')
              for name in ('scores', 'classes', 'ranges', 'objects', 'calibration', 'costs')]
    parts.append(markdown_html((report / 'conditions.md').read_text()))
    parts.append('<h1>Settings</h1>')
    for file in sorted((report / 'settings').glob('*.yaml')):
        parts.append(f'<details><summary>{html.escape(file.stem)}</summary>'
                     f'<pre>{html.escape(file.read_text())}</pre></details>')
    style = ('body{font:15px sans-serif;max-width:1300px;margin:2em auto}table{border-collapse:collapse}'
             'td,th{border:1px solid #ccc;padding:3px 8px;text-align:right}img{max-width:100%}')
    (report / 'index.html').write_text('<!DOCTYPE html><html><head><meta charset="utf-8"><title>stillmap report'
                                       f'</title><style>{style}</style></head><body>\n' + '\n'.join(parts) +
                                       '\n</body></html>\n')


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    report = pathlib.Path(sys.argv[1])
    if not (report / 'tables.md').exists():
        sys.exit(f'plot_report.py: {report}: no tables.md in it; expected a folder that stillmap evaluate wrote')
    draw_figures(report)
    write_page(report)


if __name__ == '__main__':
    main()
