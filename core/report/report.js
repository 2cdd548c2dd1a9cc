(function () {
  'use strict';
  function key(row, column) {
    return row.cells[column].getAttribute('data-sort');
  }
  function compare(a, b, numeric) {
    return numeric ? parseFloat(a) - parseFloat(b) : a.localeCompare(b, undefined, { numeric: true });
  }
  function sort(table, column, numeric, ascending) {
    var body = table.tBodies[0];
    var rows = Array.prototype.slice.call(body.rows);
    rows.sort(function (first, second) {
      var a = key(first, column), b = key(second, column);
      if (a === '' || b === '') return (a === '') - (b === ''); // unknown values stay below, whichever way
      return compare(a, b, numeric) * (ascending ? 1 : -1);
    });
    rows.forEach(function (row) { body.appendChild(row); });
  }
  Array.prototype.forEach.call(document.querySelectorAll('table.sortable'), function (table) {
    var heads = Array.prototype.slice.call(table.tHead.rows[0].cells);
    heads.forEach(function (head, column) {
      var button = document.createElement('button');
      button.type = 'button';
      while (head.firstChild) button.appendChild(head.firstChild);
      head.appendChild(button);
      button.addEventListener('click', function () {
        var ascending = head.getAttribute('aria-sort') !== 'ascending';
        heads.forEach(function (other) { other.removeAttribute('aria-sort'); });
        head.setAttribute('aria-sort', ascending ? 'ascending' : 'descending');
        sort(table, column, head.hasAttribute('data-numeric'), ascending);
      });
    });
  });
  document.addEventListener('keydown', function (event) {
    var step = { j: 1, k: -1 }[event.key];
    if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
    var cards = Array.prototype.filter.call(document.querySelectorAll('.card'), function (card) {
      return card.offsetParent !== null;
    });
    var tops = cards.map(function (card) { return card.getBoundingClientRect().top - 54; });
    var next = step > 0 ? tops.findIndex(function (top) { return top > 4; })
      : tops.length - 1 - tops.slice().reverse().findIndex(function (top) { return top < -4; });
    if (cards[next]) cards[next].scrollIntoView();
  });
})();
