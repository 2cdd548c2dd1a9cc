(function () {
  'use strict';
  var ROWS = 100, NEAR_PX = 9;
  var data = JSON.parse(document.getElementById('data').textContent);
  var photos = data.photos.map(function (row, index) {
    return { number: index + 1, status: row[0], name: row[1], origin: row[2], reason: row[3], keys: row[4],
      words: row[5], place: row[6], thumb: row[7],
      text: (row[1] + ' ' + row[2] + ' ' + row[3]).toLowerCase() };
  });
  var table = document.getElementById('table'), body = table.tBodies[0];
  var canvas = document.getElementById('map'), here = document.getElementById('here');
  var search = document.getElementById('search');
  var shown = photos, first = 0, order = null, view = null, hovered = null;

  function all(selector) { return Array.prototype.slice.call(document.querySelectorAll(selector)); }
  function page(photo) { return data.folder + '/page-' + ('000' + photo.thumb[0]).slice(-4); }
  function link(photo) { return page(photo) + '.html#photo-' + photo.number; }
  function add(parent, name, words, kind) {
    var made = document.createElement(name);
    if (words) made.textContent = words;
    if (kind) made.className = kind;
    return parent.appendChild(made);
  }

  function key(photo, column) {
    return column === 0 ? photo.status : column === 1 ? photo.name : photo.keys[column - 2];
  }
  function compare(a, b) {
    var x = key(a, order.column), y = key(b, order.column);
    if (x === '' || y === '') return (x === '') - (y === '') || a.number - b.number; // unknown values stay below
    var by = order.column === 1 ? x.localeCompare(y, undefined, { numeric: true }) : x - y;
    return by * order.sign || a.number - b.number;
  }

  function select() {
    var on = {}, words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    all('.status').forEach(function (box) { on[box.value] = box.checked; });
    shown = photos.filter(function (photo) {
      return on[data.statuses[photo.status][0]] && (!here.checked || isInView(photo)) &&
        words.every(function (word) { return photo.text.indexOf(word) >= 0; });
    });
    if (order) shown.sort(compare);
    first = 0;
    list();
    draw();
  }

  function row(photo) {
    var line = add(body, 'tr', '', 'is-' + data.statuses[photo.status][0]), cell = add(line, 'td');
    if (photo.thumb[2]) {
      var open = add(cell, 'a', '', 'thumb'), at = photo.thumb[1], wide = data.place[2];
      open.href = link(photo);
      open.setAttribute('aria-hidden', 'true');
      open.tabIndex = -1;
      open.style.width = photo.thumb[2] + 'px';
      open.style.height = photo.thumb[3] + 'px';
      open.style.backgroundImage = 'url("' + page(photo) + '.jpg")';
      open.style.backgroundPosition = -(at % wide) * data.place[0] + 'px ' + -Math.floor(at / wide) * data.place[1] + 'px';
    }
    add(add(line, 'td'), 'span', data.statuses[photo.status][1], 'badge');
    var name = add(line, 'td', '', 'name-cell'), anchor = add(name, 'a');
    add(anchor, 'bdi', photo.name);
    anchor.href = link(photo);
    [photo.origin, photo.reason].filter(Boolean).forEach(function (words) {
      add(name, 'br');
      add(name, 'span', words, 'quiet');
    });
    photo.words.forEach(function (words) { add(line, 'td', words, 'number'); });
  }
  function list() {
    var last = Math.min(first + ROWS, shown.length);
    body.textContent = '';
    shown.slice(first, last).forEach(row);
    document.getElementById('found').textContent =
      data.found.replace('{count}', shown.length).replace('{all}', photos.length);
    all('.at').forEach(function (at) {
      at.textContent = shown.length ? data.rows.replace('{first}', first + 1).replace('{last}', last) : '';
    });
    all('.pager button').forEach(function (button) {
      button.disabled = button.getAttribute('data-step') > 0 ? last >= shown.length : first === 0;
    });
  }

  all('.pager button').forEach(function (button) {
    button.addEventListener('click', function () {
      first = Math.max(0, first + ROWS * button.getAttribute('data-step'));
      list();
      if (table.getBoundingClientRect().top < 0) table.scrollIntoView();
    });
  });
  Array.prototype.slice.call(table.tHead.rows[0].cells, 1).forEach(function (head, column) {
    var button = document.createElement('button');
    button.type = 'button';
    while (head.firstChild) button.appendChild(head.firstChild);
    head.appendChild(button);
    if (column > 1) head.className = 'number';
    button.addEventListener('click', function () {
      var up = head.getAttribute('aria-sort') !== 'ascending';
      all('#table th').forEach(function (other) { other.removeAttribute('aria-sort'); });
      head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
      order = { column: column, sign: up ? 1 : -1 };
      select();
    });
  });
  all('.status').concat([here]).forEach(function (box) { box.addEventListener('change', select); });
  search.addEventListener('input', select);

  // The map: x = view.x + east * view.scale, y = view.y - north * view.scale [CSS pixels].
  var placed = photos.filter(function (photo) { return photo.place; });
  function range(index) {
    var low = Infinity, high = -Infinity;
    placed.forEach(function (photo) {
      low = Math.min(low, photo.place[index]);
      high = Math.max(high, photo.place[index]);
    });
    return [low, high];
  }
  function whole() {
    var box = canvas.getBoundingClientRect(), east = range(0), north = range(1), margin = 50;
    var scale = Math.min((box.width - 2 * margin) / Math.max(east[1] - east[0], 200),
      (box.height - 2 * margin) / Math.max(north[1] - north[0], 200));
    view = { scale: scale, x: box.width / 2 - (east[0] + east[1]) / 2 * scale,
      y: box.height / 2 + (north[0] + north[1]) / 2 * scale };
  }
  function point(photo) {
    return [view.x + photo.place[0] * view.scale, view.y - photo.place[1] * view.scale];
  }
  function isInView(photo) {
    if (!photo.place || !view) return false;
    var at = point(photo), box = canvas.getBoundingClientRect();
    return at[0] >= 0 && at[0] <= box.width && at[1] >= 0 && at[1] <= box.height;
  }
  function draw() {
    var box = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    if (!placed.length || !box.width) return;
    if (!view) whole();
    canvas.width = box.width * ratio;
    canvas.height = box.height * ratio;
    var pen = canvas.getContext('2d'), style = getComputedStyle(document.documentElement);
    var colours = data.statuses.map(function (status) { return style.getPropertyValue('--' + status[0]); });
    pen.scale(ratio, ratio);
    var visible = shown.filter(isInView), wedges = visible.length <= 1500;
    var length = visible.length <= 200 ? 40 : 18;
    if (wedges) visible.forEach(function (photo) {
      if (photo.place[2] === null || photo.place[3] === null) return;
      var at = point(photo), middle = (photo.place[2] - 90) * Math.PI / 180, half = photo.place[3] * Math.PI / 360;
      pen.globalAlpha = 0.22;
      pen.fillStyle = colours[photo.status];
      pen.beginPath();
      pen.moveTo(at[0], at[1]);
      pen.arc(at[0], at[1], length, middle - half, middle + half);
      pen.fill();
    });
    pen.globalAlpha = visible.length > 3000 ? 0.6 : 1;
    visible.forEach(function (photo) {
      var at = point(photo);
      pen.fillStyle = colours[photo.status];
      pen.beginPath();
      pen.arc(at[0], at[1], photo === hovered ? 6 : visible.length > 500 ? 2.5 : 4, 0, 2 * Math.PI);
      pen.fill();
    });
    pen.globalAlpha = 1;
    bar(pen, box, style.getPropertyValue('--ink'));
  }
  function bar(pen, box, ink) {
    var most = 0.2 * box.width / view.scale, power = Math.pow(10, Math.floor(Math.log(most) / Math.LN10 + 1e-9));
    var length = power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1), y = box.height - 10;
    pen.strokeStyle = pen.fillStyle = ink;
    pen.beginPath();
    pen.moveTo(12, y - 5);
    pen.lineTo(12, y);
    pen.lineTo(12 + length * view.scale, y);
    pen.lineTo(12 + length * view.scale, y - 5);
    pen.stroke();
    pen.font = '12px system-ui, sans-serif';
    pen.fillText(length >= 1000 ? length / 1000 + ' km' : length + ' m', 16, y - 8);
  }
  function near(event) {
    var box = canvas.getBoundingClientRect(), best = null, least = NEAR_PX * NEAR_PX;
    if (!view) return null;
    shown.forEach(function (photo) {
      if (!photo.place) return;
      var at = point(photo), x = at[0] - event.clientX + box.left, y = at[1] - event.clientY + box.top;
      if (x * x + y * y < least) { least = x * x + y * y; best = photo; }
    });
    return best;
  }

  var grip = null;
  canvas.addEventListener('pointerdown', function (event) {
    grip = { x: event.clientX, y: event.clientY, moved: false };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', function (event) {
    if (grip && view) {
      var x = event.clientX - grip.x, y = event.clientY - grip.y;
      if (!grip.moved && Math.abs(x) + Math.abs(y) < 4) return;
      grip = { x: event.clientX, y: event.clientY, moved: true };
      view.x += x;
      view.y += y;
      draw();
      return;
    }
    var found = near(event);
    if (found === hovered) return;
    hovered = found;
    canvas.title = found ? found.name + (found.words[0] === '–' ? '' : ': ' + found.words[0]) : '';
    canvas.classList.toggle('on-photo', !!found);
    draw();
  });
  canvas.addEventListener('pointerup', function (event) {
    var moved = grip && grip.moved, found = near(event);
    grip = null;
    if (moved) { if (here.checked) select(); }
    else if (found) location.href = link(found);
  });
  canvas.addEventListener('wheel', function (event) {
    if (!view) return;
    event.preventDefault();
    var box = canvas.getBoundingClientRect(), by = Math.exp(-event.deltaY * 0.0015);
    var x = event.clientX - box.left, y = event.clientY - box.top;
    view = { scale: view.scale * by, x: x + (view.x - x) * by, y: y + (view.y - y) * by };
    if (here.checked) select(); else draw();
  }, { passive: false });
  document.getElementById('whole').addEventListener('click', function () {
    whole();
    select();
  });
  window.addEventListener('resize', draw);
  if (!placed.length) document.querySelector('.map').hidden = true;
  select();
})();
