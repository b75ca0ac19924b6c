import { grabbableIn, type ObjectKey, objectsOf, ownNameOf, unitOf } from '../../core/document/index.ts';
import { type Hit, hitsAt, REACH } from '../hit-test.ts';
import type { Point } from '../view.ts';
import { CLICK_SLOP, type LastClick, type PointerContext, type PointerInput } from './state.ts';

/** What clicks at one place select in turn. */
type Unit = readonly ObjectKey[];

const isSame = (a: Unit, b: Unit): boolean => a.length === b.length && a.every((key) => b.includes(key));

/** The objects at the pointer that the canvas can select, the one that a first click means first. */
export const hitsOf = (context: PointerContext, { place, by }: Pick<PointerInput, 'place' | 'by'>): Hit[] =>
  hitsAt(grabbableIn(context.document.file()).values(), context.her(), place, REACH[by] / context.view().zoom);

/** The last click if this input is at the same place and nothing else was selected since; else null. */
export function lastClickAt(context: PointerContext, { place, by }: Pick<PointerInput, 'place' | 'by'>): LastClick | null {
  const last = context.clicks.getState();
  if (last === null || last.selected !== context.selection.keys()) return null;
  const slop = CLICK_SLOP[by === 'touch' ? 'touch' : 'mouse'];
  const apart = Math.hypot(place.x - last.place.x, place.y - last.place.y) * context.view().zoom;
  return apart <= slop ? last : null;
}

/** What clicks select at these hits: each group once, or single objects. */
function unitsOf(context: PointerContext, hits: readonly Hit[], isSingle: boolean): { readonly unit: Unit; readonly hit: Hit }[] {
  const file = context.document.file();
  const selected = context.selection.keys();
  const units: { readonly unit: Unit; readonly hit: Hit }[] = [];
  for (const hit of hits) {
    if (!isSingle && units.some(({ unit }) => unit.includes(hit.key))) continue;
    units.push({ unit: isSingle ? [hit.key] : unitOf(file, hit.key, selected), hit });
  }
  return units;
}

/**
 * Selects what a click at a place means. A click at the same place again selects the next object there, in turn.
 * @param isSingle whether single members of groups are meant
 */
export function clickAt(context: PointerContext, input: Pick<PointerInput, 'place' | 'by'>, isSingle: boolean): void {
  const { selection } = context;
  const units = unitsOf(context, hitsOf(context, input), isSingle);
  if (units.length === 0) return;
  const last = lastClickAt(context, input);
  const now = last?.isSingle === isSingle ? units.findIndex(({ unit }) => isSame(unit, selection.keys())) : -1;
  const index = (now + 1) % units.length;
  const { unit, hit } = units[index];
  selection.select(unit);
  context.clicks.setState({ place: input.place, isSingle, hit, selected: selection.keys() }, true);
  if (units.length > 1) context.say(`${index + 1} of ${units.length} here: ${nameOfUnit(context, unit)}`, input.place);
}

function nameOfUnit({ document }: PointerContext, unit: Unit): string {
  const found = objectsOf(document.file()).get(unit[0]);
  if (unit.length > 1 || found === undefined) return `${unit.length} objects`;
  return ownNameOf(found);
}

/** Selects the next object at the place of the last click, or at another place. */
export function clickAgain(context: PointerContext, place: Point): void {
  clickAt(context, { place, by: 'keys' }, context.clicks.getState()?.isSingle ?? false);
}

/** A double-click on a member of a group selects the member alone. */
export function enterGroup(context: PointerContext, input: PointerInput): void {
  const [hit] = hitsOf(context, input);
  if (hit === undefined || context.tool() !== 'select') return;
  const { selection, document } = context;
  if (unitOf(document.file(), hit.key, []).length < 2) return;
  selection.select([hit.key]);
  context.clicks.setState({ place: input.place, isSingle: true, hit, selected: selection.keys() }, true);
}
