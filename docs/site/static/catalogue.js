// SPDX-License-Identifier: Apache-2.0
// The table of all schemes: sorted by a click on a head, filtered by words or column=value.
document.addEventListener('DOMContentLoaded', () => {
  const table = document.querySelector('table.catalogue');
  if (!table) return;
  const body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  const rows = [...body.rows];
  const valueOf = (row, column) => row.cells[column].dataset.value;

  const compare = (a, b) => {
    const [x, y] = [Number(a), Number(b)];
    return Number.isNaN(x) || Number.isNaN(y) ? a.localeCompare(b) : x - y;
  };
  heads.forEach((head, column) => {
    head.addEventListener('click', () => {
      const up = head.getAttribute('aria-sort') !== 'ascending';
      heads.forEach((other) => other.removeAttribute('aria-sort'));
      head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
      rows.sort((a, b) => (up ? 1 : -1) * compare(valueOf(a, column), valueOf(b, column)));
      body.append(...rows);
    });
  });

  const names = heads.map((head) => head.textContent.toLowerCase());
  const fits = (row, word) => {
    const [column, value] = word.split('=');
    if (value === undefined) return row.textContent.toLowerCase().includes(word);
    const at = names.findIndex((name) => name.replaceAll(' ', '').includes(column));
    return at >= 0 && valueOf(row, at).toLowerCase().startsWith(value);
  };
  document.querySelector('.catalogue-filter').addEventListener('input', (event) => {
    const words = event.target.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of rows) row.hidden = !words.every((word) => fits(row, word));
  });
});
