import type { GameObjects, Scene } from 'phaser';
import { appearanceOfObject, DEFAULT_RANGE, type Disc, KINDS } from '../../../schema/index.ts';
import {
  type FoundObject,
  hiddenIn,
  type ObjectKey,
  objectsOf,
  placesOf,
  radiusOf,
  visibleIn,
} from '../../core/document/index.ts';
import type { CanvasState } from '../canvas-state.ts';
import { type Colours, colourNumber } from '../colours.ts';
import { boxesOf, type SelectionBox, selectionBox } from '../extent.ts';
import { REACH, resizedByRim } from '../hit-test.ts';
import type { Picture } from '../picture.ts';
import { drawnBox, handlesOf } from '../selection-handles.ts';
import { type Point, toLevel, type View } from '../view.ts';
import { Rings } from './rings.ts';

/** px of screen below which grid lines are too close to be drawn */
const GRID_LEAST = 7;
/** every eighth grid line is stronger */
const GRID_STRONG = 8;
/** more range discs than this are not drawn */
const MOST_RANGES = 60;
/** px of screen between an object and its selection outline */
const OUTLINE = 3;
/** directions of the handles on a rim */
const HANDLES = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;
/** px of screen of a dash, and of the gap after it, in the line that links the places of one object */
const DASH = 6;
const MOST_DASHES = 200;

/** What the overlays depend on; the selection, the grid and the guides are hidden in a playtest. */
type OverlayInput = Pick<Picture, 'file' | 'her' | 'canvas' | 'selected' | 'hovered' | 'layers' | 'grid' | 'editing'>;

/** The objects that are shown: hidden ones only in a playtest. */
const shownIn = ({ file, editing }: OverlayInput): ReadonlyMap<ObjectKey, FoundObject> =>
  editing ? visibleIn(file) : objectsOf(file);

/** The ends of a line between two discs of equal radius, from rim to rim; from centre to centre if they overlap. */
function betweenRims(from: Point, to: Point, radius: number): [Point, Point] {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(dx, dy);
  if (length <= 2 * radius) return [from, to];
  const [outX, outY] = [(dx / length) * radius, (dy / length) * radius];
  return [
    { x: from.x + outX, y: from.y + outY },
    { x: to.x - outX, y: to.y - outY },
  ];
}

/** The aids for editing, below and above the objects: grid, range of the gun, hazard margins, selection, guides, marquee. */
export class OverlayLayer {
  private readonly below: GameObjects.Graphics;
  private readonly above: GameObjects.Graphics;
  /** Margins of hazards that are not selected, and of selected ones, which move in a drag. */
  private readonly margins: Rings;
  private readonly chosenMargins: Rings;
  private readonly outlines: Rings;
  /** the input that the rings were last made from */
  private ringed: OverlayInput | null = null;

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.below = scene.add.graphics().setDepth(0);
    this.margins = new Rings(scene).setDepth(0.1);
    this.chosenMargins = new Rings(scene).setDepth(0.1);
    this.outlines = new Rings(scene).setDepth(19);
    this.above = scene.add.graphics().setDepth(20);
  }

  show(input: OverlayInput): void {
    const { below, above } = this;
    below.clear();
    above.clear();
    if (input.editing && input.grid !== null) this.grid(input.grid, input.canvas);
    if (input.layers.ranges) this.ranges(input);
    this.links(input);
    this.rings(input);
    if (!input.editing) return;
    this.selection(input);
    this.gesture(input.canvas);
  }

  destroy(): void {
    this.below.destroy();
    this.above.destroy();
    this.margins.destroy();
    this.chosenMargins.destroy();
    this.outlines.destroy();
  }

  private grid(size: number, { view }: CanvasState): void {
    let step = size;
    while (step * view.zoom < GRID_LEAST) step *= GRID_STRONG;
    const from = toLevel(view, { x: 0, y: 0 });
    const to = toLevel(view, { x: view.width, y: view.height });
    // One stroke for all lines: hundreds of strokes would take milliseconds per frame.
    for (const strong of [false, true]) {
      this.below.lineStyle(1 / view.zoom, colourNumber(this.colours.grid), strong ? 0.16 : 0.06).beginPath();
      for (let k = Math.ceil(from.x / step); k * step <= to.x; k++) {
        if ((k % GRID_STRONG === 0) === strong) this.below.moveTo(k * step, from.y).lineTo(k * step, to.y);
      }
      for (let k = Math.ceil(from.y / step); k * step <= to.y; k++) {
        if ((k % GRID_STRONG === 0) === strong) this.below.moveTo(from.x, k * step).lineTo(to.x, k * step);
      }
      this.below.strokePath();
    }
  }

  /** The reach of the gun: she is lost outside all of these discs. */
  private ranges({ file, canvas, selected, editing }: OverlayInput): void {
    const hidden: ReadonlySet<ObjectKey | undefined> = hiddenIn(file);
    const range = file.range ?? DEFAULT_RANGE;
    const colour = colourNumber(this.colours.range);
    const asteroids = (file.asteroids ?? []).filter(({ id }) => !editing || !hidden.has(id));
    // Hundreds of overlapping discs show nothing, so only those of selected asteroids are drawn, if there are few enough.
    const chosen: ReadonlySet<ObjectKey | undefined> = new Set(selected);
    const shown = asteroids.length > MOST_RANGES ? asteroids.filter(({ id }) => chosen.has(id)) : asteroids;
    if (shown.length > MOST_RANGES) return;
    for (const { id, x, y } of shown) {
      const isSelected = chosen.has(id);
      this.below.fillStyle(colour, isSelected ? 0.07 : 0.03).fillCircle(x, y, range);
      this.below.lineStyle((isSelected ? 1.5 : 1) / canvas.view.zoom, colour, isSelected ? 0.6 : 0.22).strokeCircle(x, y, range);
    }
  }

  /** Dashed lines between the places of one object, to show that they belong together. */
  private links(input: OverlayInput): void {
    const { canvas, selected, hovered } = input;
    const { zoom } = canvas.view;
    for (const found of shownIn(input).values()) {
      if (KINDS[found.kind].places.length < 2) continue;
      const [first, ...others] = placesOf(found);
      const isMeant = found.key === hovered || selected.includes(found.key);
      this.below.lineStyle(1.5 / zoom, colourNumber(this.colours.label), isMeant ? 0.8 : 0.35).beginPath();
      for (const other of others) this.dashes(...betweenRims(first, other, radiusOf(found) ?? 0), zoom);
      this.below.strokePath();
    }
  }

  private dashes(from: Point, to: Point, zoom: number): void {
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    const count = Math.min(MOST_DASHES, Math.ceil((length * zoom) / (2 * DASH)));
    for (let i = 0; i < count; i++) {
      const at = (share: number) => [from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share] as const;
      this.below.moveTo(...at(i / count)).lineTo(...at((i + 0.5) / count));
    }
  }

  /** Rings are made again when what they surround changes. */
  private rings(input: OverlayInput): void {
    const last = this.ringed;
    const { zoom } = input.canvas.view;
    const same = (...names: readonly (keyof OverlayInput)[]) =>
      last !== null && names.every((name) => last[name] === input[name]);
    if (same('file', 'her', 'selected', 'layers', 'editing')) {
      for (const rings of [this.margins, this.chosenMargins, this.outlines]) rings.zoomTo(zoom);
      return;
    }
    this.ringed = input;
    const chosen: ReadonlySet<ObjectKey> = new Set(input.editing ? input.selected : []);
    const around = { still: [] as Disc[], chosen: [] as Disc[], outlined: [] as Disc[] };
    const { halfWidth, halfHeight } = input.her;
    const least = Math.min(halfWidth, halfHeight);
    const shown = shownIn(input);
    for (const found of objectsOf(input.file).values()) {
      const radius = radiusOf(found);
      if (radius === null) continue;
      const isChosen = chosen.has(found.key);
      const hasMargin = input.layers.margins && shown.has(found.key) && appearanceOfObject(found.kind, found.object).deadly;
      for (const { x, y } of placesOf(found)) {
        if (isChosen) around.outlined.push({ x, y, radius });
        // how close her centre may come to a hazard at the most favourable rotation of her box
        if (hasMargin) around[isChosen ? 'chosen' : 'still'].push({ x, y, radius: radius + least });
      }
    }
    const margin = { colour: colourNumber(this.colours.danger), alpha: 0.3, width: 1, off: 0 };
    this.margins.show(around.still, margin, zoom);
    this.chosenMargins.show(around.chosen, margin, zoom);
    const outline = { colour: colourNumber(this.colours.select), alpha: 1, width: 2, off: OUTLINE };
    this.outlines.show(around.outlined, outline, zoom);
  }

  private selection({ file, her, canvas, selected, hovered }: OverlayInput): void {
    const { zoom } = canvas.view;
    const objects = objectsOf(file);
    const outline = (key: ObjectKey, width: number, alpha: number) => {
      const found = objects.get(key);
      if (found === undefined) return;
      const off = OUTLINE / zoom;
      this.above.lineStyle(width / zoom, colourNumber(this.colours.select), alpha);
      const isRound = radiusOf(found) !== null;
      for (const { left, top, right, bottom } of boxesOf(her, found)) {
        const [x, y] = [(left + right) / 2, (top + bottom) / 2];
        if (isRound) this.above.strokeCircle(x, y, (right - left) / 2 + off);
        else this.above.strokeRect(left - off, top - off, right - left + 2 * off, bottom - top + 2 * off);
      }
    };
    if (hovered !== null && !selected.includes(hovered)) outline(hovered, 1.5, 0.6);
    for (const key of selected) {
      const found = objects.get(key);
      // round objects have rings instead
      if (found !== undefined && radiusOf(found) === null) outline(key, 2, 1);
    }
    drawSelectionBox(this.above, selectionBox(file, her, selected), canvas.view, colourNumber(this.colours.select));
    const half = 3.5 / zoom;
    for (const found of resizedByRim(file, selected, REACH.mouse / zoom)) {
      const radius = radiusOf(found) ?? 0;
      for (const place of placesOf(found)) {
        for (const [dx, dy] of HANDLES) {
          const x = place.x + dx * radius;
          const y = place.y + dy * radius;
          this.above.fillStyle(0xffffff, 1).fillRect(x - half, y - half, 2 * half, 2 * half);
          this.above.lineStyle(1.5 / zoom, colourNumber(this.colours.select), 1);
          this.above.strokeRect(x - half, y - half, 2 * half, 2 * half);
        }
      }
    }
  }

  private gesture({ view, marquee, guides, placing, crosshair }: CanvasState): void {
    const select = colourNumber(this.colours.select);
    if (marquee !== null) {
      const { left, top, right, bottom } = marquee;
      this.above.fillStyle(select, 0.12).fillRect(left, top, right - left, bottom - top);
      this.above.lineStyle(1 / view.zoom, select, 0.9).strokeRect(left, top, right - left, bottom - top);
    }
    this.above.lineStyle(1 / view.zoom, colourNumber(this.colours.guide), 0.95);
    for (const { axis, at, from, to } of guides) {
      if (axis === 'x') this.above.lineBetween(at, from, at, to);
      else this.above.lineBetween(from, at, to, at);
    }
    if (placing !== null) {
      const arm = 9 / view.zoom;
      this.above.lineStyle(1.5 / view.zoom, select, 0.9);
      this.above.lineBetween(placing.x - arm, placing.y, placing.x + arm, placing.y);
      this.above.lineBetween(placing.x, placing.y - arm, placing.x, placing.y + arm);
    }
    if (crosshair !== null) this.crosshair(crosshair, view);
  }

  /** Thin lines across the whole view, and a cross with a ring that stands out against any background. */
  private crosshair({ x, y }: Point, view: View): void {
    const from = toLevel(view, { x: 0, y: 0 });
    const to = toLevel(view, { x: view.width, y: view.height });
    const [near, far] = [5 / view.zoom, 20 / view.zoom];
    this.above.lineStyle(1 / view.zoom, colourNumber(this.colours.select), 0.5);
    this.above.lineBetween(from.x, y, x - near, y).lineBetween(x + near, y, to.x, y);
    this.above.lineBetween(x, from.y, x, y - near).lineBetween(x, y + near, x, to.y);
    for (const [width, colour, alpha] of [
      [5, this.colours.space, 0.75],
      [2, this.colours.select, 1],
    ] as const) {
      this.above.lineStyle(width / view.zoom, colourNumber(colour), alpha);
      this.above.lineBetween(x - far, y, x - near, y).lineBetween(x + near, y, x + far, y);
      this.above.lineBetween(x, y - far, x, y - near).lineBetween(x, y + near, x, y + far);
      this.above.strokeCircle(x, y, 10 / view.zoom);
    }
    this.above.fillStyle(colourNumber(this.colours.select), 1).fillCircle(x, y, 1.5 / view.zoom);
  }
}

/** px of screen: half of the side of a handle, and the radius of the one that turns */
const HALF = 4;
const ROUND = 5;

/** Draws the box around the selection with its handles: squares scale it, the circle turns it. */
function drawSelectionBox(graphics: GameObjects.Graphics, selection: SelectionBox | null, view: View, colour: number): void {
  if (selection === null) return;
  const { zoom } = view;
  const { left, top, right, bottom } = drawnBox(selection, zoom);
  graphics.lineStyle(1 / zoom, colour, 0.8).strokeRect(left, top, right - left, bottom - top);
  for (const { handle, at } of handlesOf(selection, view)) {
    graphics.lineStyle(1.5 / zoom, colour, 1);
    if (handle.does === 'turn') {
      graphics.lineBetween(at.x, at.y < top ? at.y + ROUND / zoom : at.y - ROUND / zoom, at.x, at.y < top ? top : bottom);
      graphics
        .fillStyle(0xffffff, 1)
        .fillCircle(at.x, at.y, ROUND / zoom)
        .strokeCircle(at.x, at.y, ROUND / zoom);
      continue;
    }
    const half = HALF / zoom;
    graphics.fillStyle(0xffffff, 1).fillRect(at.x - half, at.y - half, 2 * half, 2 * half);
    graphics.strokeRect(at.x - half, at.y - half, 2 * half, 2 * half);
  }
}
