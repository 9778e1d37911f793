// monitor/web/src/field_view.ts: the field to scale and everything that moves on it, as SVG.
import type { MonitorField, MonitorUpdate, MonitorField_Line } from "./generated/monitor_pb";
import type { Truth } from "./generated/recording_pb";
import type { Ellipse } from "./ellipse";
import { Keyed, set, svg, write } from "./dom";
import { type BallMark, isImported, type ObstacleMark, type RobotMark, type Scene } from "./scene";
import { OpponentNumbers } from "./opponent_numbers";
import { RawLayer, Trails } from "./raw_layer";
import { UNITS, View } from "./view";
import { WithoutLayer } from "./without_layer";

/** An arrow shows where something will be after so many seconds. */
const ARROW_S = 0.7;
const SLOWEST_ARROW_MPS = 0.15;
/** Symbols never get smaller than this on the screen, so that they can be read at 3 m; in rem. */
const ROBOT_REM = 0.75;
const BALL_REM = 0.36;
const OBSTACLE_REM = 0.6;
const ROBOT_M = 0.25;
const BALL_M = 0.11;
const GOAL_COLOURS = ["none", "blue", "yellow", "white"];

interface Symbol {
  root: SVGGElement;
  ellipse: SVGEllipseElement;
  arrow: SVGLineElement;
  body: SVGElement;
  nose: SVGElement;
  label: SVGTextElement;
}

function makeSymbol(parent: Element, kind: string, body: "circle" | "rect"): Symbol {
  const root = svg("g", { class: kind }, parent);
  return {
    root,
    ellipse: svg("ellipse", { class: "spread" }, root),
    arrow: svg("line", { class: "velocity", "marker-end": "url(#head)" }, root),
    nose: svg("path", { class: "nose" }, root),
    body: svg(body, { class: "body" }, root),
    label: svg("text", { class: "label" }, root),
  };
}

/** Draws one field; made again when the field changes. */
export class FieldView {
  private readonly root: SVGSVGElement;
  private readonly paint: SVGGElement;
  private readonly layers: Record<"truth" | "raw" | "trails" | "links" | "obstacles" | "robots" | "balls" | "without" | "ghost", SVGGElement>;
  private readonly robots: Keyed<Symbol>;
  private readonly balls: Keyed<Symbol>;
  private readonly obstacles: Keyed<Symbol>;
  private readonly links: Keyed<SVGLineElement>;
  private readonly truths: Keyed<SVGCircleElement>;
  private readonly raw: RawLayer;
  private readonly trails: Trails;
  private readonly without: WithoutLayer;
  private readonly numbers = new OpponentNumbers();
  private view = new View(false);
  private field: MonitorField | undefined;
  private unitsPerPixel = 1;
  private unitsPerRem = 16;

  constructor(parent: HTMLElement) {
    this.root = svg("svg", { class: "pitch", preserveAspectRatio: "xMidYMid meet" }, parent);
    const head = svg("marker", { id: "head", viewBox: "0 0 8 8", refX: 5, refY: 4, markerWidth: 3.4, markerHeight: 3.4, orient: "auto-start-reverse" }, svg("defs", {}, this.root));
    svg("path", { d: "M0 0.6 L7 4 L0 7.4 z", fill: "context-stroke" }, head);
    this.paint = svg("g", { class: "paint" }, this.root);
    const layer = (name: string): SVGGElement => svg("g", { class: `layer-${name}` }, this.root);
    this.layers = {
      truth: layer("truth"),
      raw: layer("raw"),
      trails: layer("trails"),
      links: layer("links"),
      obstacles: layer("obstacles"),
      robots: layer("robots"),
      balls: layer("balls"),
      without: layer("without"),
      ghost: layer("ghost"),
    };
    this.raw = new RawLayer(this.layers.raw);
    this.trails = new Trails(this.layers.trails);
    this.without = new WithoutLayer(this.layers.without);
    const symbols = (kind: string, body: "circle" | "rect", on: SVGGElement): Keyed<Symbol> =>
      new Keyed(() => {
        const item = makeSymbol(on, kind, body);
        return { item, root: item.root };
      });
    this.robots = symbols("robot", "circle", this.layers.robots);
    this.balls = symbols("ball-mark", "circle", this.layers.balls);
    this.obstacles = symbols("obstacle", "rect", this.layers.obstacles);
    this.links = new Keyed(() => {
      const item = svg("line", {}, this.layers.links);
      return { item, root: item };
    });
    this.truths = new Keyed(() => {
      const item = svg("circle", { class: "truth" }, this.layers.truth);
      return { item, root: item };
    });
    new ResizeObserver(() => this.measure()).observe(parent);
  }

  setField(field: MonitorField): void {
    this.field = field;
    const wide = (field.lengthM + 2 * field.surroundM) * UNITS;
    const high = (field.widthM + 2 * field.surroundM) * UNITS;
    const centre = this.view.place(field.centreXM, field.centreYM);
    set(this.root, { viewBox: `${centre.x - wide / 2} ${centre.y - high / 2} ${wide} ${high}` });
    this.paint.replaceChildren();
    svg("rect", { class: "carpet", x: centre.x - wide / 2, y: centre.y - high / 2, width: wide, height: high, rx: 12 }, this.paint);
    this.drawPaint(field);
    this.measure();
  }

  flip(): void {
    this.view = new View(!this.view.flipped);
    if (this.field) this.setField(this.field);
  }

  get isFlipped(): boolean {
    return this.view.flipped;
  }

  /** A point of the screen in F, metres. */
  toField(clientX: number, clientY: number): { x: number; y: number } {
    const matrix = this.root.getScreenCTM();
    if (!matrix) return { x: 0, y: 0 };
    const at = new DOMPoint(clientX, clientY).matrixTransform(matrix.inverse());
    const sign = this.view.flipped ? -1 : 1;
    return { x: (sign * at.x) / UNITS, y: (-sign * at.y) / UNITS };
  }

  /** Where a robot is being put, in F; nothing: no more. */
  ghost(from: { x: number; y: number } | undefined, to: { x: number; y: number } | undefined): void {
    this.layers.ghost.replaceChildren();
    if (!from || !to) return;
    const [a, b] = [this.view.place(from.x, from.y), this.view.place(to.x, to.y)];
    svg("circle", { class: "ghost", cx: a.x, cy: a.y, r: Math.max(ROBOT_M * UNITS, ROBOT_REM * this.unitsPerRem) }, this.layers.ghost);
    svg("line", { class: "ghost", x1: a.x, y1: a.y, x2: b.x, y2: b.y, "stroke-width": 3 * this.unitsPerPixel, "marker-end": "url(#head)" }, this.layers.ghost);
  }

  /** @param raw  what each robot sees: "none", "all", or one robot's */
  draw(scene: Scene, update: MonitorUpdate, raw: "none" | "all" | number): void {
    if (raw === "none") this.raw.clear();
    else this.raw.draw(update, this.view, this.unitsPerPixel, raw === "all" ? undefined : raw);
    const hasIds = !isImported(update);
    if (hasIds) this.trails.draw(update, this.view, this.unitsPerPixel);
    this.drawTruth(update.truth);
    this.drawObstacles(scene.obstacles, Number(update.stampNs) / 1e6, hasIds);
    this.drawLinks(scene);
    this.drawRobots(scene.robots);
    this.drawBalls(scene.balls, update.hint?.trackId ?? 0);
    this.without.draw(update, this.view, this.unitsPerPixel);
  }

  private measure(): void {
    const box = this.root.viewBox.baseVal;
    const { width, height } = this.root.getBoundingClientRect();
    if (!box || box.width === 0 || width === 0 || height === 0) return;
    this.unitsPerPixel = Math.max(box.width / width, box.height / height);
    this.unitsPerRem = this.unitsPerPixel * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  }

  private line(line: MonitorField_Line, className: string, width: number): void {
    const from = this.view.place(line.fromXM, line.fromYM);
    const to = this.view.place(line.toXM, line.toYM);
    svg("line", { class: className, x1: from.x, y1: from.y, x2: to.x, y2: to.y, "stroke-width": width }, this.paint);
  }

  private drawPaint(field: MonitorField): void {
    const width = Math.max(field.lineWidthM * UNITS, 3);
    for (const goal of field.goals) {
      if (!goal.mouth) continue;
      const sign = (goal.mouth.fromXM + goal.mouth.toXM) / 2 < field.centreXM ? -1 : 1;
      const post = this.view.place(goal.mouth.fromXM, goal.mouth.fromYM);
      const back = this.view.place(goal.mouth.toXM + sign * goal.depthM, goal.mouth.toYM);
      const box = { x: Math.min(post.x, back.x), y: Math.min(post.y, back.y), width: Math.abs(post.x - back.x), height: Math.abs(post.y - back.y) };
      svg("rect", { class: `goal goal-${GOAL_COLOURS[goal.colour] ?? "none"}`, ...box }, this.paint);
    }
    for (const wall of field.walls) this.line(wall, "wall", 2 * width);
    for (const line of field.lines) this.line(line, "line", width);
    for (const arc of field.arcs) {
      const at = (angle: number) =>
        this.view.place(arc.centreXM + arc.radiusM * Math.cos(angle), arc.centreYM + arc.radiusM * Math.sin(angle));
      const radius = arc.radiusM * UNITS;
      // Two halves: one SVG arc cannot be a whole circle.
      const [from, middle, to] = [at(arc.startRad), at(arc.startRad + arc.sweepRad / 2), at(arc.startRad + arc.sweepRad)];
      const large = arc.sweepRad / 2 > Math.PI ? 1 : 0;
      const part = (end: { x: number; y: number }) => `A${radius} ${radius} 0 ${large} 0 ${end.x} ${end.y}`;
      svg("path", { class: "line", d: `M${from.x} ${from.y}${part(middle)}${part(to)}`, "stroke-width": width }, this.paint);
    }
    for (const spot of field.spots) {
      const at = this.view.place(spot.xM, spot.yM);
      svg("circle", { class: "spot", cx: at.x, cy: at.y, r: Math.max(spot.radiusM * UNITS, width) }, this.paint);
    }
  }

  /** Places a symbol with its ellipse and arrow; what is not known is not drawn. */
  private place(symbol: Symbol, x: number, y: number, ellipse: Ellipse | undefined, velocity?: { x: number; y: number }): void {
    const at = this.view.place(x, y);
    set(symbol.root, { transform: `translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})` });
    set(symbol.ellipse, { visibility: ellipse ? "visible" : "hidden" });
    if (ellipse) {
      set(symbol.ellipse, { rx: ellipse.major * UNITS, ry: ellipse.minor * UNITS, transform: `rotate(${this.view.rotation(ellipse.angle).toFixed(1)})` });
    }
    const moves = velocity !== undefined && Math.hypot(velocity.x, velocity.y) > SLOWEST_ARROW_MPS;
    set(symbol.arrow, { visibility: moves ? "visible" : "hidden" });
    if (moves) {
      const tip = this.view.place(velocity.x * ARROW_S, velocity.y * ARROW_S);
      set(symbol.arrow, { x1: 0, y1: 0, x2: tip.x, y2: tip.y, "stroke-width": 3 * this.unitsPerPixel });
    }
  }

  private drawRobots(marks: RobotMark[]): void {
    const size = Math.max(ROBOT_M * UNITS, ROBOT_REM * this.unitsPerRem);
    for (const mark of marks) {
      const symbol = this.robots.get(String(mark.id));
      this.place(symbol, mark.x, mark.y, mark.ellipse);
      set(symbol.root, { class: `robot ${mark.freshness}${mark.fused ? "" : " own-word"}${mark.quarantined ? " quarantined" : ""}`, "data-robot": mark.id, "data-x": mark.x, "data-y": mark.y });
      set(symbol.body, { r: size });
      set(symbol.nose, { d: `M${size * 0.55} ${-size * 0.84} L${size * 1.75} 0 L${size * 0.55} ${size * 0.84} z`, transform: `rotate(${this.view.rotation(mark.theta).toFixed(1)})` });
      set(symbol.label, { "font-size": size * 1.35 });
      write(symbol.label, String(mark.id));
    }
    this.robots.keepOnly(new Set(marks.map((mark) => String(mark.id))));
  }

  /** @param hinted  the one that the operator means; 0: none */
  private drawBalls(marks: BallMark[], hinted: number): void {
    const size = Math.max(BALL_M * UNITS, BALL_REM * this.unitsPerRem);
    marks.forEach((mark, index) => {
      const symbol = this.balls.get(String(mark.id));
      this.place(symbol, mark.x, mark.y, mark.ellipse, { x: mark.vx, y: mark.vy });
      set(symbol.root, { class: `ball-mark ${mark.freshness}${index > 0 ? " second" : ""}${mark.id === hinted ? " hinted" : ""}`, opacity: 0.35 + 0.65 * mark.existence });
      // A ball in the air is nearer to whoever looks from above.
      set(symbol.body, { r: size * (1 + Math.min(Math.max(mark.z - BALL_M, 0), 3) * 0.4) });
    });
    this.balls.keepOnly(new Set(marks.map((mark) => String(mark.id))));
  }

  /** @param hasIds  whether an id names the same one all the time */
  private drawObstacles(marks: ObstacleMark[], nowMs: number, hasIds: boolean): void {
    this.numbers.show(marks.map((mark) => mark.id), nowMs);
    for (const mark of marks) {
      const symbol = this.obstacles.get(String(mark.id));
      const size = Math.max(mark.radius * UNITS, OBSTACLE_REM * this.unitsPerRem);
      this.place(symbol, mark.x, mark.y, mark.ellipse, { x: mark.vx, y: mark.vy });
      set(symbol.root, { class: `obstacle ${mark.freshness}`, "data-track": mark.id, opacity: 0.3 + 0.7 * mark.existence });
      set(symbol.body, { x: -size, y: -size, width: 2 * size, height: 2 * size, rx: size * 0.45 });
      set(symbol.label, { "font-size": size * 1.35 });
      write(symbol.label, hasIds ? String(this.numbers.of(mark.id)) : "");
    }
    this.obstacles.keepOnly(new Set(marks.map((mark) => String(mark.id))));
  }

  /** Who the first ball comes from, and who contradicts it. */
  private drawLinks(scene: Scene): void {
    const keys = new Set<string>();
    const ball = scene.balls[0];
    for (const robot of ball ? scene.robots : []) {
      const supports = ball!.supporters.includes(robot.id);
      if (!supports && !ball!.rejected.includes(robot.id)) continue;
      const from = this.view.place(robot.x, robot.y);
      const to = this.view.place(ball!.x, ball!.y);
      keys.add(String(robot.id));
      set(this.links.get(String(robot.id)), { class: supports ? "supports" : "contradicts", x1: from.x, y1: from.y, x2: to.x, y2: to.y, "stroke-width": 1.5 * this.unitsPerPixel });
    }
    this.links.keepOnly(keys);
  }

  private drawTruth(truth: Truth | undefined): void {
    const keys = new Set<string>();
    const ring = (key: string, x: number, y: number, radius: number): void => {
      const at = this.view.place(x, y);
      keys.add(key);
      set(this.truths.get(key), { cx: at.x, cy: at.y, r: radius, "stroke-width": 1.5 * this.unitsPerPixel });
    };
    for (const robot of truth?.robots ?? []) {
      ring(`robot ${robot.robotId}`, robot.xM, robot.yM, Math.max(ROBOT_M * UNITS, ROBOT_REM * this.unitsPerRem) * 1.3);
    }
    if (truth?.ballPM) ring("ball", truth.ballPM.x, truth.ballPM.y, Math.max(BALL_M * UNITS, BALL_REM * this.unitsPerRem) * 1.6);
    this.truths.keepOnly(keys);
  }
}
