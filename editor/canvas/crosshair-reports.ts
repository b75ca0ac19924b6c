import type { StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../schema/index.ts';
import {
  type FoundObject,
  lockedIn,
  nameOf,
  type ObjectKey,
  objectsOf,
  placesOf,
  radiusOf,
  visibleIn,
} from '../core/document/index.ts';
import { type Hit, hitsAt, hitTest, REACH } from './hit-test.ts';
import type { PointerContext } from './pointer/index.ts';
import type { Point } from './view.ts';

/** The level and the selection at one moment. */
export interface Moment {
  readonly file: LevelFile;
  readonly keys: readonly ObjectKey[];
}

/** Announces what the crosshair does, for screen readers. */
export class CrosshairReports {
  /** Whether a held key moves the crosshair: its position is announced when the key is released. */
  isPending = false;

  constructor(
    private readonly context: PointerContext,
    private readonly said: StoreApi<string>,
  ) {}

  report(text: string): void {
    this.isPending = false;
    this.said.setState(text, true);
  }

  /** What lies at a point, in words. */
  thing(place: Point): string {
    const { document, selection } = this.context;
    const hit = under(this.context, place);
    return hit === null
      ? passedByInWords(lockedUnder(this.context, place))
      : thingInWords(document.file(), hit, selection.keys());
  }

  /** @param why announced first */
  reportPlace(place: Point, why: string): void {
    this.report(`${why}. ${placeInWords(place)}, ${this.thing(place)}`);
  }

  /** Announces where the crosshair is, and what is there or what the drag has done. @param held null: no drag */
  reportStep(place: Point, held: Moment | null): void {
    const { document, selection, canvas } = this.context;
    const here = placeInWords(place);
    if (held === null) this.report(`${here}, ${this.thing(place)}`);
    else if (canvas.getState().marquee !== null) this.report(`${here}, ${selection.keys().length} selected`);
    else this.report(changeInWords(held.file, document.file()) ?? here);
  }

  /** Announces what has changed since a moment. */
  reportDone(place: Point, { file, keys }: Moment): void {
    const { document, selection } = this.context;
    const now = document.file();
    this.report(changeInWords(file, now) ?? `${selectionInWords(now, keys, selection.keys())}. ${placeInWords(place)}`);
  }
}

/** What lies under the crosshair; null: nothing. */
export function under(context: PointerContext, place: Point): Hit | null {
  const selected = context.tool() === 'select' ? context.selection.keys() : [];
  return hitTest(context.document.file(), context.her(), place, REACH.keys / context.view().zoom, selected);
}

/** The locked object under the crosshair, which can't be grabbed; null: none. */
function lockedUnder(context: PointerContext, place: Point): FoundObject | null {
  const file = context.document.file();
  const visible = visibleIn(file);
  const locked = [...lockedIn(file)].flatMap((key) => visible.get(key) ?? []);
  const [hit] = hitsAt(locked, context.her(), place, REACH.keys / context.view().zoom);
  return hit === undefined ? null : (visible.get(hit.key) ?? null);
}

const number = (value: number): string => String(Number(value.toFixed(2)));

/** `x 448, y 304` */
export const placeInWords = ({ x, y }: Point): string => `x ${number(x)}, y ${number(y)}`;

/** `asteroid 2`, and whether it is selected or its rim can be dragged. */
function thingInWords(file: LevelFile, hit: Hit, selected: readonly ObjectKey[]): string {
  const found = objectsOf(file).get(hit.key);
  if (found === undefined) return 'empty';
  const name = nameOf(found).toLowerCase();
  return `${hit.part === 'rim' ? `rim of ${name}` : name}${selected.includes(hit.key) ? ', selected' : ''}`;
}

/** What the crosshair passes by: `asteroid 2, locked`, or `empty`. */
const passedByInWords = (locked: FoundObject | null): string =>
  locked === null ? 'empty' : `${nameOf(locked).toLowerCase()}, locked`;

const withRadius = (found: FoundObject): string => {
  const radius = radiusOf(found);
  return radius === null ? '' : `, radius ${number(radius)}`;
};

/**
 * What was added, moved or resized between two states of a level: `Asteroid 4 added at x 448, y 304, radius 16`; null: nothing.
 */
function changeInWords(before: LevelFile, after: LevelFile): string | null {
  const old = objectsOf(before);
  const all = [...objectsOf(after).values()];
  const [added, ...others] = all.filter(({ key }) => !old.has(key));
  if (added !== undefined) {
    return others.length > 0
      ? `${others.length + 1} objects added`
      : `${nameOf(added)} added at ${placeInWords(added.object)}${withRadius(added)}`;
  }
  const changed = all.filter(({ key, object }) => old.get(key)?.object !== object);
  const [first] = changed;
  const was = first === undefined ? undefined : old.get(first.key);
  if (was === undefined) return null;
  const then = placesOf(was);
  const moved = placesOf(first).find(({ x, y }, i) => x !== then[i].x || y !== then[i].y);
  if (changed.length > 1) return `${changed.length} objects ${moved === undefined ? 'resized' : 'moved'}`;
  return moved === undefined ? `${nameOf(first)}${withRadius(first)}` : `${nameOf(first)} moved to ${placeInWords(moved)}`;
}

/** How Enter or a marquee changed the selection. */
function selectionInWords(file: LevelFile, before: readonly ObjectKey[], after: readonly ObjectKey[]): string {
  const named = (key: ObjectKey | undefined) => {
    const found = key === undefined ? undefined : objectsOf(file).get(key);
    return found === undefined ? '' : nameOf(found);
  };
  const gone = before.filter((key) => !after.includes(key));
  if (after.length === 0) return 'Nothing is selected';
  if (gone.length === 1 && after.length === before.length - 1)
    return `${named(gone[0])} is no longer selected, ${after.length} still selected`;
  if (after.length === 1) return `${named(after[0])} is selected`;
  const added = after.filter((key) => !before.includes(key));
  return added.length === 1 ? `${named(added[0])} is selected, ${after.length} in all` : `${after.length} objects are selected`;
}
