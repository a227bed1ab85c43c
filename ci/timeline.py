# SPDX-License-Identifier: Apache-2.0
"""What a build made when, as a picture: one row for each that worked at once, one bar for each output."""
import hashlib
from html import escape
from pathlib import Path

from objects import LINKING, SHARED_HEADERS, Fault, folder_of

WIDTH, ROW, MARGIN = 1400, 26, 40
SHORTEST_WITH_NAME = 60  # pixels


def edges(build):
    """(begin, end, outputs) in seconds of each command, in order of begin; of the longest run that the log has."""
    log = Path(build) / '.ninja_log'
    if not log.exists():
        raise Fault(f'no {log}: nothing was built there by ninja')
    runs, last = [], float('inf')
    for line in log.read_text().splitlines():
        if line.startswith('#'):
            continue
        begin, end, _, output, command = line.split('\t')
        if int(end) < last:  # the clock begins anew with each run
            runs.append({})
        last = int(end)
        runs[-1].setdefault((int(begin) / 1000, last / 1000, command), []).append(output)
    if not runs:
        raise Fault(f'{log} is empty: nothing was built there')
    longest = max(runs, key=lambda run: max(end for _, end, _ in run))
    return sorted((begin, end, outputs) for (begin, end, _), outputs in longest.items())


def rows_of(intervals):
    """For each interval, in order of begin, the first row that is free."""
    free, rows = [], []
    for begin, end in intervals:
        row = next((at for at, until in enumerate(free) if until <= begin), len(free))
        free[row:row + 1] = [end]
        rows.append(row)
    return rows


def room_of(folder):
    return '/'.join(folder.split('/')[:2])


def colour(room):
    if room in (LINKING, SHARED_HEADERS):
        return '#bbb'
    return f'hsl({int(hashlib.sha256(room.encode()).hexdigest()[:4], 16) % 360},55%,72%)'


def name_of(output, folder):
    """What stands on a bar: the source, or the folder whose sources are joined."""
    file = output.split('/')[-1]
    if not output.endswith('.o'):
        return file
    return folder if '/Unity/' in output else f'{folder}/{file.split(".")[0]}'


def legend(made, build, y):
    """The rooms that took longest, with their minutes."""
    seconds = {}
    for begin, end, outputs in made:
        room = room_of(folder_of(outputs[0], build))
        seconds[room] = seconds.get(room, 0) + end - begin
    x = MARGIN
    for room, total in sorted(seconds.items(), key=lambda row: -row[1])[:8]:
        yield f'<rect x="{x}" y="{y}" width="10" height="10" fill="{colour(room)}"/>'
        yield f'<text x="{x + 14}" y="{y + 9}">{escape(room)} {total / 60:.1f} min</text>'
        x += (WIDTH - 2 * MARGIN) // 8


def drawn(build):
    """The picture as SVG."""
    made = edges(build)
    length = max(end for _, end, _ in made)
    rows = rows_of([(begin, end) for begin, end, _ in made])
    scale = (WIDTH - 2 * MARGIN) / length
    height = (max(rows) + 1) * ROW + 2 * MARGIN + ROW
    bottom = height - MARGIN - ROW
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" font-family="sans-serif" font-size="11">',
           '<rect width="100%" height="100%" fill="white"/>']
    step = next(one for one in (1, 5, 10, 30, 60, 120, 300, 600, 1800, 3600, 10 ** 9) if length / one <= 20)
    for tick in range(0, int(length) + 1, step):
        x = MARGIN + tick * scale
        label = f'{tick // 60} min' if step >= 60 else f'{tick} s'
        out.append(f'<path d="M{x:.1f} {MARGIN}V{bottom}" stroke="#ccc"/>'
                   f'<text x="{x:.1f}" y="{bottom + 16}" text-anchor="middle">{label}</text>')
    for (begin, end, outputs), row in zip(made, rows):
        folder = folder_of(outputs[0], build)
        x, y, width = MARGIN + begin * scale, MARGIN + row * ROW, max((end - begin) * scale, 0.5)
        name = name_of(outputs[0], folder)
        out.append(f'<g><title>{escape(outputs[0])}: {end - begin:.1f} s</title>'
                   f'<rect x="{x:.1f}" y="{y}" width="{width:.1f}" height="{ROW - 4}" fill="{colour(room_of(folder))}" stroke="white" stroke-width="0.5"/>')
        if width >= SHORTEST_WITH_NAME:
            room = int(width / 6.2)
            if len(name) > room:
                name = name.split('/')[-1][:room]
            out.append(f'<text x="{x + 3:.1f}" y="{y + 15}">{escape(name)}</text>')
        out.append('</g>')
    out += legend(made, build, height - ROW)
    busy = sum(end - begin for begin, end, _ in made)
    out.append(f'<text x="{MARGIN}" y="{MARGIN - 14}" font-size="14">{len(made)} steps in {length / 60:.1f} min, '
               f'{busy / length:.1f} at once on average</text></svg>')
    return '\n'.join(out) + '\n'
