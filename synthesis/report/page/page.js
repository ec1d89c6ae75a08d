"use strict";
// Moves the drawing, keeps plots and controls in step with it, and switches between designs.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const $ = (id) => document.getElementById(id);
  document.body.classList.replace("still", "live");
  const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const svgNamespace = "http://www.w3.org/2000/svg";

  let design;        // that shows
  let frames;        // places of its bodies, for each assembly
  let plots = [];    // of dygraphs, with their cursors
  let share = 0;     // of the motion, 0 to 1
  let playing = false;
  let backward = false;  // of a motion that goes to and fro
  let lastTime = 0;

  const angleAt = (part) => design.from + (design.to - design.from) * part;
  const shareAt = (angle) => Math.min(1, Math.max(0, (angle - design.from) / (design.to - design.from)));

  // Position and direction of a body: between two steps in proportion.
  function placeOf(assembly, body, part) {
    const { numbers, scale } = frames[assembly];
    const at = part * design.steps, step = Math.min(Math.floor(at), design.steps - 1), rest = at - step;
    const stride = 4 * design.bodies.length;
    const value = (k) => {
      const i = step * stride + 4 * body + k;
      return numbers[i] * (1 - rest) + numbers[i + stride] * rest;
    };
    const cosine = value(2), sine = value(3), length = Math.hypot(cosine, sine);
    if (length === 0) return null;
    return { x: value(0) * scale, y: value(1) * scale, cosine: cosine / length, sine: sine / length };
  }

  function move(groups, assembly) {
    groups.forEach((group, body) => {
      const place = placeOf(assembly, body, share);
      group.style.display = place ? "" : "none";
      if (!place) return;
      const { cosine, sine } = place;
      group.setAttribute("transform", `matrix(${cosine} ${-sine} ${sine} ${cosine} ${place.x} ${place.y})`);
      for (const name of group.querySelectorAll(".name"))  // stays upright
        name.setAttribute("transform", `matrix(${cosine} ${sine} ${-sine} ${cosine} ${name.dataset.x} ${name.dataset.y})`);
    });
  }

  function show() {
    move(bodies(".own"), 0);
    if (frames.length > 1 && $("other").checked) move(bodies(".other"), 1);
    const angle = angleAt(share);
    $("angle").value = Math.round(share * design.steps);
    const text = `${angle.toFixed(design.unit === "deg" ? 1 : 3)} ${design.unit}`;
    $("angle-text").textContent = text;
    $("angle").setAttribute("aria-valuetext", text);
    for (const { graph, cursor, readings, plot } of plots) {
      cursor.style.left = `${graph.toDomXCoord(angle)}px`;
      readings.forEach((reading, i) => { reading.textContent = near(plot.values[i]); });
    }
  }

  // The value of a curve at the angle that shows.
  function near(values) {
    const value = values[Math.round(share * design.steps)];
    return Number.isFinite(value) ? Number(value.toPrecision(5)) : "–";
  }

  const bodies = (kind) => Array.from(document.querySelectorAll(`#drawing > ${kind} > .body`));

  function colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  }

  function drawLevels(context, area, graph, levels) {
    context.save();
    context.strokeStyle = colour("--path");
    context.fillStyle = colour("--path");
    context.font = "11px sans-serif";
    context.setLineDash([5, 4]);
    for (const [name, value] of levels) {
      const y = graph.toDomYCoord(value);
      context.beginPath();
      context.moveTo(area.x, y);
      context.lineTo(area.x + area.w, y);
      context.stroke();
      context.fillText(name, area.x + 6, y - 3);
    }
    context.restore();
  }

  // The frame of a plot. Its graph is made when all frames stand, since each takes width from the others.
  function addFrame(plot) {
    const holder = document.createElement("div");
    holder.className = "plot";
    const heading = document.createElement("h3");
    heading.textContent = plot.title + (plot.unit ? `, ${plot.unit}` : "");
    const legend = document.createElement("div");
    legend.className = "legend";
    const readings = plot.curves.map(([name], i) => {
      const label = document.createElement("span"), reading = document.createElement("span");
      label.textContent = `${name} `;
      label.style.color = `var(--curve-${i % 5})`;
      reading.className = "reading";
      legend.append(label, reading);
      return reading;
    });
    const area = document.createElement("div");
    area.className = "curves";
    area.setAttribute("role", "img");
    holder.append(heading, legend, area);
    $("plots").append(holder);
    return { plot, heading: heading.textContent, readings, area };
  }

  // Whole sixths of a turn where angles are degrees.
  function ticksOfDegrees(from, to) {
    const span = to - from, step = [5, 10, 15, 30, 60, 90, 180].find((s) => span / s <= 7) || 360;
    const ticks = [];
    for (let v = Math.ceil(from / step) * step; v <= to + 1e-9; v += step) ticks.push({ v, label: `${v}` });
    return ticks;
  }

  function addGraph({ plot, heading, readings, area }) {
    plot.values = plot.curves.map(([, numbers]) => new Float32Array(bytesOf(numbers)));
    const rows = [];
    for (let i = 0; i <= design.steps; ++i)
      rows.push([angleAt(i / design.steps), ...plot.values.map((v) => (Number.isFinite(v[i]) ? v[i] : null))]);
    const finite = plot.values.flatMap((v) => Array.from(v)).filter(Number.isFinite);
    const all = finite.concat(plot.levels.map((level) => level[1]));
    const low = Math.min(...all), high = Math.max(...all), room = 0.08 * (high - low) || 1;
    area.setAttribute("aria-label", `${heading} over ${design.name}: ` +
      plot.curves.map(([name], i) => {
        const known = Array.from(plot.values[i]).filter(Number.isFinite);
        return `${name} from ${Math.min(...known).toPrecision(5)} to ${Math.max(...known).toPrecision(5)}`;
      }).join(", "));
    const graph = new Dygraph(area, rows, {
      labels: [design.name, ...plot.curves.map(([name]) => name)],
      ...coloursOf(plot),
      strokeWidth: 1.7,
      valueRange: [low - room, high + room],
      labelsShowZeroValues: true,
      legend: "never",
      axes: {
        x: design.unit === "deg" ? { ticker: ticksOfDegrees } : { pixelsPerLabel: 60 },
        y: { axisLabelWidth: 56 },
      },
      underlayCallback: (context, box, self) => drawLevels(context, box, self, plot.levels),
      clickCallback: (_, angle) => { share = shareAt(angle); show(); },
      highlightCircleSize: 3,
    });
    const cursor = document.createElement("i");
    cursor.className = "cursor";
    area.append(cursor);
    plots.push({ graph, cursor, readings, plot });
  }

  // Canvases do not read the style of the page.
  function coloursOf(plot) {
    return {
      colors: plot.curves.map((_, i) => colour(`--curve-${i % 5}`)),
      gridLineColor: colour("--line"),
      axisLineColor: colour("--faint"),
    };
  }

  function makePlots() {
    for (const { graph } of plots) graph.destroy();
    plots = [];
    $("plots").replaceChildren();
    design.plots.map(addFrame).forEach(addGraph);
  }

  // The bodies in a group of their own, once for each assembly.
  function makeBodies() {
    const drawing = $("drawing");
    whole();
    drawing.innerHTML = design.drawing;
    const own = drawing.querySelector("#bodies");
    own.setAttribute("class", "own");
    if (frames.length > 1) {
      const other = own.cloneNode(true);
      other.removeAttribute("id");
      other.setAttribute("class", "other");
      drawing.insertBefore(other, own);
    }
    $("other-label").style.display = frames.length > 1 ? "" : "none";
    $("other-label").lastChild.textContent = frames.length > 1 ? ` ${frames[1].name} assembly` : "";
  }

  function choose(index) {
    design = data.designs[index];
    frames = design.assemblies.map(({ scale, places }) => ({
      scale, numbers: new Int16Array(bytesOf(places)), name: null }));
    design.assemblies.forEach(({ name }, i) => { frames[i].name = name; });
    document.querySelectorAll(".choice").forEach((button) =>
      button.setAttribute("aria-pressed", String(Number(button.dataset.design) === index)));
    $("angle").max = design.steps;
    $("angle-name").textContent = design.name;
    $("speed-name").textContent = ["deg", "rad"].includes(design.unit) ? "turns per minute" : "strokes per minute";
    $("save-dxf").style.display = design.dxf ? "" : "none";
    $("angle").setAttribute("aria-label", `${design.name} in ${design.unit}`);
    $("numbers").innerHTML = design.tables;
    makeBodies();
    showOther();
    makePlots();
    share = shareAt(design.start);
    backward = false;
    show();
  }

  function showOther() {
    const shown = frames.length > 1 && $("other").checked;
    for (const group of document.querySelectorAll("#drawing > .other")) group.style.display = shown ? "" : "none";
  }

  // Of the motion, once; a stroke of a driven slide is to and fro.
  function seconds() {
    const turn = { deg: 360, rad: 2 * Math.PI }[design.unit] || 2 * (design.to - design.from);
    const perMinute = Math.min(600, Math.max(0.1, Number($("speed").value) || 15));
    return 60 / perMinute * (design.to - design.from) / turn;
  }

  function advance(time) {
    if (!playing) return;
    const step = Math.min(100, time - lastTime) / 1000 / seconds();
    lastTime = time;
    share += backward ? -step : step;
    if (design.closed) {
      share -= Math.floor(share);
    } else if (share > 1 || share < 0) {
      share = share > 1 ? 2 - share : -share;
      share = Math.min(1, Math.max(0, share));
      backward = !backward;
    }
    show();
    requestAnimationFrame(advance);
  }

  function play(on) {
    playing = on;
    $("play").textContent = on ? "Pause" : "Play";
    $("play").setAttribute("aria-pressed", String(on));
    if (!on) return;
    lastTime = performance.now();
    requestAnimationFrame(advance);
  }

  // The part of the drawing that shows: x, y, width, height.
  let view = [0, 0, 1, 1];

  function look(part) {
    view = part;
    $("drawing").setAttribute("viewBox", view.join(" "));
    $("drawing").classList.toggle("zoomed", view.join(" ") !== design.box);
  }

  const whole = () => look(design.box.split(" ").map(Number));

  // Around a place of the drawing, which stays where it is; never more than all of it.
  function zoom(times, at) {
    const [x, y, width, height] = view, all = design.box.split(" ").map(Number);
    const size = Math.min(1, Math.max(1 / 64, width / times / all[2]));
    if (size === 1) return whole();
    const [u, v] = at || [x + width / 2, y + height / 2];
    return look([u - (u - x) * size * all[2] / width, v - (v - y) * size * all[3] / height,
      size * all[2], size * all[3]]);
  }

  function placeInDrawing(event) {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform($("drawing").getScreenCTM().inverse());
    return [at.x, at.y];
  }

  function listenToZoom() {
    $("nearer").addEventListener("click", () => zoom(1.5));
    $("farther").addEventListener("click", () => zoom(1 / 1.5));
    $("whole").addEventListener("click", whole);
    $("full").addEventListener("click", () =>
      (document.fullscreenElement ? document.exitFullscreen() : $("mechanism").requestFullscreen()));
    document.addEventListener("fullscreenchange", () => {
      $("full").textContent = document.fullscreenElement ? "Leave full screen" : "Full screen";
    });
    // Elsewhere a wheel moves the page; two fingers come as a wheel with this key.
    $("drawing").addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !document.fullscreenElement) return;
      event.preventDefault();
      zoom(Math.exp(-event.deltaY / 400), placeInDrawing(event));
    }, { passive: false });
    let held = null;
    $("drawing").addEventListener("pointerdown", (event) => {
      if (view.join(" ") === design.box) return;
      held = placeInDrawing(event);
      $("drawing").setPointerCapture(event.pointerId);
    });
    $("drawing").addEventListener("pointermove", (event) => {
      if (!held) return;
      const at = placeInDrawing(event);
      look([view[0] + held[0] - at[0], view[1] + held[1] - at[1], view[2], view[3]]);
    });
    for (const end of ["pointerup", "pointercancel"]) $("drawing").addEventListener(end, () => { held = null; });
  }

  // The drawing as it shows, whole, with its styles in it.
  const inherited = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin",
    "stroke-linecap", "opacity", "font-family", "font-size", "paint-order"];

  function drawnSvg() {
    const drawing = $("drawing"), [x, y, width, height] = design.box.split(" ").map(Number);
    const copy = drawing.cloneNode(true);
    const shown = drawing.querySelectorAll("*");
    copy.querySelectorAll("*").forEach((element, i) => {
      const style = getComputedStyle(shown[i]);
      for (const name of inherited) element.setAttribute(name, style.getPropertyValue(name));
      if (style.display === "none") element.setAttribute("display", "none");
      element.removeAttribute("style");
    });
    for (const name of ["id", "class", "style"]) copy.removeAttribute(name);
    copy.setAttribute("xmlns", svgNamespace);
    copy.setAttribute("viewBox", design.box);
    copy.setAttribute("width", width);
    copy.setAttribute("height", height);
    const paper = document.createElementNS(svgNamespace, "rect");
    for (const [name, value] of Object.entries({ x, y, width, height, fill: colour("--panel") }))
      paper.setAttribute(name, value);
    copy.prepend(paper);
    return new XMLSerializer().serializeToString(copy);
  }

  // The curves of the plots at every step, as a table.
  function motionTable() {
    const head = (name, unit) => (unit ? `"${name} (${unit})"` : `"${name}"`);
    const rows = [[head(design.name, design.unit),
      ...plots.flatMap(({ plot }) => plot.curves.map(([name]) => head(name, plot.unit)))]];
    for (let i = 0; i <= design.steps; ++i)
      rows.push([Number(angleAt(i / design.steps).toPrecision(12)), ...plots.flatMap(({ plot }) =>
        plot.values.map((values) => (Number.isFinite(values[i]) ? Number(values[i].toPrecision(7)) : "")))]);
    return rows.map((row) => `${row.join(",")}\n`).join("");
  }

  // Every frame of the motion, to and fro where it does not close, drawn by `take`.
  async function eachFrame(count, take) {
    const before = share, frames = design.closed ? count : 2 * count;
    for (let i = 0; i < frames; ++i) {
      share = design.closed ? i / frames : 1 - Math.abs(1 - 2 * i / frames);
      show();
      const picture = new Image();
      picture.src = `data:image/svg+xml,${encodeURIComponent(drawnSvg())}`;
      await picture.decode();
      take(picture);
    }
    share = before;
    show();
  }

  async function movingPicture() {
    const [, , width, height] = design.box.split(" ").map(Number);
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext("2d", { willReadFrequently: true });
    const frames = [];
    await eachFrame(45, (picture) => {
      context.drawImage(picture, 0, 0, width, height);
      frames.push(context.getImageData(0, 0, width, height).data);
    });
    const once = design.closed ? seconds() : 2 * seconds();
    return gifOf(frames, width, height, Math.max(2, Math.round(100 * once / frames.length)));
  }

  function save(content, type, ending) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([content], { type }));
    link.download = `${design.file}.${ending}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  function listenToSave() {
    $("save-svg").addEventListener("click", () => save(drawnSvg(), "image/svg+xml", "svg"));
    $("save-dxf").addEventListener("click", () => save(design.dxf, "image/vnd.dxf", "dxf"));
    $("save-csv").addEventListener("click", () => save(motionTable(), "text/csv", "csv"));
    $("save-gif").addEventListener("click", async () => {
      play(false);
      $("save-gif").disabled = true;
      const picture = await movingPicture().finally(() => { $("save-gif").disabled = false; });
      save(picture, "image/gif", "gif");
    });
  }

  function listen() {
    listenToZoom();
    listenToSave();
    $("play").addEventListener("click", () => play(!playing));
    $("angle").addEventListener("input", (event) => {
      share = Number(event.target.value) / design.steps;
      show();
    });
    $("other").addEventListener("change", () => { showOther(); show(); });
    $("ghosts").addEventListener("change", (event) =>
      $("drawing").classList.toggle("no-ghosts", !event.target.checked));
    document.querySelectorAll(".choice").forEach((button) =>
      button.addEventListener("click", () => choose(Number(button.dataset.design))));
    document.addEventListener("keydown", (event) => {
      const typing = event.target.closest("input, select, button, summary, .chart");
      if (event.key === " " && !typing) {
        event.preventDefault();
        play(!playing);
      }
    });
  }

  function resizePlots() {
    for (const { graph, plot } of plots) {
      graph.updateOptions(coloursOf(plot), true);
      graph.resize();
    }
    show();
  }
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", resizePlots);

  // A sheet of paper is narrower than the window, and always light. Canvases are printed as they are: they are only
  // made smaller, and dark ones turned round by the style of the page.
  const millimetre = 96 / 25.4;
  window.addEventListener("beforeprint", () => {
    const many = plots.length > 4, widthOnPaper = (many ? 60 : 92) * millimetre;
    $("plots").classList.toggle("many", many);
    document.documentElement.classList.toggle("was-dark", dark.matches);
    for (const holder of document.querySelectorAll(".plot")) {
      const width = holder.getBoundingClientRect().width;
      holder.style.width = `${width}px`;
      holder.style.zoom = widthOnPaper / width;
    }
  });
  window.addEventListener("afterprint", () => {
    for (const holder of document.querySelectorAll(".plot")) holder.removeAttribute("style");
  });

  // Charts of a study: the point nearest to a click.
  const { charts, columns, points } = data.study;
  const logarithm = (chart, value) => (chart.log ? Math.log(value) : value);
  const partX = (chart, x) => (logarithm(chart, x) - logarithm(chart, chart.x[0])) /
    (logarithm(chart, chart.x[1]) - logarithm(chart, chart.x[0]));
  const partY = (chart, y) => (y - chart.y[0]) / (chart.y[1] - chart.y[0]);

  // Where a point is in a chart's picture, as shares of its width and height; null where it is not in it.
  function placeInChart(index, point) {
    const chart = charts[index], x = point.at[2 * index], y = point.at[2 * index + 1];
    if (x === null || y === null) return null;
    const [left, right, bottom, top] = chart.box;
    return [left + (right - left) * partX(chart, x), bottom + (top - bottom) * partY(chart, y)];
  }

  let chosen = -1;

  function open(point) {
    chosen = point;
    const { values, design: index } = points[point];
    const table = document.createElement("table");
    columns.forEach((name, i) => {
      if (values[i] === null) return;
      const row = table.insertRow(), head = document.createElement("th");
      head.textContent = name;
      row.append(head);
      row.insertCell().textContent = values[i];
    });
    $("point").replaceChildren(table);
    if (index < 0) $("point").append("This page does not hold the design of this point.");
    document.querySelectorAll(".chart").forEach((figure, i) => {
      const place = placeInChart(i, points[point]), mark = figure.querySelector(".mark");
      mark.hidden = place === null;
      if (place) {
        mark.style.left = `${100 * place[0]}%`;
        mark.style.top = `${100 * place[1]}%`;
      }
    });
    if (index >= 0) choose(index);
  }

  // The point that is nearest to a place of the chart; `wanted` says which ones count.
  function nearest(index, at, wanted) {
    let best = -1, least = Infinity;
    points.forEach((point, i) => {
      const place = placeInChart(index, point);
      if (!place || !wanted(place, i)) return;
      const distance = Math.hypot(place[0] - at[0], place[1] - at[1]);
      if (distance < least) [best, least] = [i, distance];
    });
    return best;
  }

  document.querySelectorAll(".chart").forEach((figure, index) => {
    figure.addEventListener("click", (event) => {
      const box = figure.querySelector("svg").getBoundingClientRect();
      const at = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
      const point = nearest(index, at, () => true);
      if (point >= 0) open(point);
    });
    figure.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!step) return;
      event.preventDefault();
      const from = chosen < 0 ? [0.5, 0.5] : placeInChart(index, points[chosen]) || [0.5, 0.5];
      // Onward means at least half as far to the side asked for as to any other.
      const point = nearest(index, from, (place, i) => {
        const dx = place[0] - from[0], dy = place[1] - from[1];
        const onward = dx * step[0] + dy * step[1];
        return i !== chosen && onward > 1e-6 && onward >= 0.9 * Math.hypot(dx, dy);
      });
      if (point >= 0) open(point);
    });
  });

  if (data.designs.length > 0) {
    listen();
    choose(0);
  }
})();
