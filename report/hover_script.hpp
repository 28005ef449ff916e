#pragma once

#include <string_view>

namespace secular::report {

/// Shows the values of the point nearest to the pointer under each figure; on the keyboard left and right step
/// through the points of a series, up and down through the series. Reads `data-plot` (figure_points.hpp). Unfolds
/// all parts for print. The page is complete without it.
inline constexpr std::string_view hover_script = R"js(
'use strict';
addEventListener('beforeprint', () => { for (const d of document.querySelectorAll('details')) d.open = true; });
for (const box of document.querySelectorAll('[data-plot]')) {
  const svg = box.querySelector('svg'), points = [];
  const mark = document.createElementNS(svg.namespaceURI, 'circle'), line = document.createElement('output');
  const place = (v, [, , low, high, log]) => log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low);
  JSON.parse(box.dataset.plot).forEach(({ box: [left, right, top, bottom], x, y, series }, panel) =>
    series.forEach(([name, values], index) => {
      for (let i = 0; values.length > i; i += 2) {
        const px = left + (right - left) * place(values[i], x), py = bottom + (top - bottom) * place(values[i + 1], y);
        if ([px - left, right - px, py - top, bottom - py].every((inside) => inside >= 0))
          points.push({ px, py, of: panel + '.' + index, text: (name ? name + ': ' : '') + x[0] + ' ' + values[i] +
            ' ' + x[1] + ', ' + y[0] + ' ' + values[i + 1] + ' ' + y[1] });
      }
    }));
  if (!points.length) continue;
  let now = -1;
  const show = (i) => {
    now = i;
    mark.setAttribute('cx', points[i].px);
    mark.setAttribute('cy', points[i].py);
    svg.append(mark);
    line.textContent = points[i].text;
  };
  mark.setAttribute('r', 7);
  mark.setAttribute('class', 'mark');
  line.className = 'values';
  box.after(line);
  svg.addEventListener('pointermove', (event) => {
    const r = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / r.width;
    const x = (event.clientX - r.left) * scale, y = (event.clientY - r.top) * scale;
    const far = (p) => Math.hypot(p.px - x, p.py - y);
    let best = 0;
    points.forEach((p, i) => {
      if (far(points[best]) > far(p)) best = i;
    });
    if (60 > far(points[best])) show(best);
  });
  box.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    let next = now + step;
    if (now >= 0) if (['ArrowDown', 'ArrowUp'].includes(event.key))
      while (points[next]?.of === points[now].of) next += step;
    show(Math.min(Math.max(next, 0), points.length - 1));
  });
}
)js";

}  // namespace secular::report
