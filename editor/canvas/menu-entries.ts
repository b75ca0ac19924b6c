import { appearanceOf, PLACEABLES } from '../../schema/index.ts';
import { keyLabel, needsOf } from '../core/commands/index.ts';
import { type Editor, IS_MAC, type OpenLevel } from '../core/context/index.ts';
import { addObject, lockedIn, objectsOf, ownNameOf, titled, visibleIn } from '../core/document/index.ts';
import { orderActions } from '../core/order/index.ts';
import type { MenuAction, MenuPart } from './canvas-state.ts';
import { hitsAt, REACH } from './hit-test.ts';
import { clickAt, hitsOf, type PointerContext, placeFor } from './pointer/index.ts';
import type { ObjectChanges } from './selection-changes.ts';
import type { Point } from './view.ts';

export interface MenuParts {
  readonly editor: Editor;
  readonly level: OpenLevel;
  readonly context: PointerContext;
  readonly changes: ObjectChanges;
  /** Pastes the clipboard around a place. */
  readonly pasteAt: (place: Point) => void;
}

const ALIGN = ['left', 'centre', 'right', 'top', 'middle', 'bottom'].map((edge) => `object.align-${edge}`);
const DISTRIBUTE = ['object.distribute-x', 'object.distribute-y'];

const TURN = ['object.turn-left-far', 'object.turn-right-far', 'object.mirror-x', 'object.mirror-y'];

/** The entry of a command; null where it is not registered. */
function ofCommand({ commands }: Editor, id: string, title?: string): MenuAction | null {
  const command = commands.all().find((one) => one.id === id);
  if (command === undefined) return null;
  const [key] = command.keys ?? [];
  return {
    title: title ?? command.title,
    ...(key === undefined ? {} : { keys: keyLabel(key, IS_MAC) }),
    disabled: needsOf(command) !== null,
    run: () => void commands.run(id),
  };
}

const isThere = (entry: MenuPart): entry is MenuAction => entry !== null;

/** What lies at the place, to be selected, also below other objects and locked. */
function thingsHere({ level, context }: MenuParts, place: Point): MenuPart[] {
  const file = level.document.file();
  const hits = hitsAt(visibleIn(file).values(), context.her(), place, REACH.mouse / context.view().zoom);
  const locked = lockedIn(file);
  const entries = hits.flatMap(({ key }): MenuAction[] => {
    const found = objectsOf(file).get(key);
    if (found === undefined) return [];
    const title = `${ownNameOf(found)}${locked.has(key) ? ', locked' : ''}`;
    return [{ title, run: () => level.selection.select([key]) }];
  });
  const isHiddenByLock = hits.some(({ key }) => locked.has(key));
  return entries.length > 1 || isHiddenByLock ? [{ title: 'Select here', entries }] : [];
}

function unlockHere({ editor, level, context }: MenuParts, place: Point): MenuPart[] {
  const file = level.document.file();
  const locked = lockedIn(file);
  const hit = hitsAt(visibleIn(file).values(), context.her(), place, REACH.mouse / context.view().zoom).find(({ key }) =>
    locked.has(key),
  );
  const found = hit === undefined ? undefined : objectsOf(file).get(hit.key);
  if (found === undefined) return [];
  return [{ title: `Unlock ${ownNameOf(found)}`, run: () => orderActions(editor, level).lock([found.key], false) }];
}

/** What can be done with the selection, by the commands that do it. */
function forSelection({ editor, level }: MenuParts): MenuPart[] {
  const of = (id: string, title?: string): MenuPart[] => {
    const entry = ofCommand(editor, id, title);
    return entry === null ? [] : [entry];
  };
  const all = (ids: readonly string[]) => ids.flatMap((id) => of(id)).filter(isThere);
  const count = level.selection.keys().length;
  return [
    ...of('object.rename', 'Name…'),
    ...of('object.lock', 'Lock or unlock'),
    ...of('object.hide', 'Hide or show'),
    ...of('object.group', 'Group'),
    ...of('object.ungroup', 'Ungroup'),
    null,
    ...of('edit.duplicate'),
    ...of('edit.copy'),
    ...of('edit.cut'),
    ...of('edit.delete'),
    null,
    ...(count > 1 ? [{ title: 'Align', entries: all([...ALIGN, ...DISTRIBUTE]) }] : []),
    { title: 'Turn and mirror', entries: all(TURN) },
    ...of('object.repeat', 'Repeat…'),
    ...of('view.fit-selection', 'Bring into view'),
  ];
}

/** What can be done at the place itself. */
function forPlace({ editor, context, changes, pasteAt }: MenuParts, place: Point): MenuPart[] {
  const at = placeFor(context, { place, mod: false });
  const add = PLACEABLES.map((kind): MenuAction => {
    const { one } = appearanceOf(kind);
    return { title: titled(one), run: () => changes.add(`Add ${one}`, addObject(kind, at.x, at.y)) };
  });
  return [
    { title: 'Add here', entries: add },
    { title: 'Paste here', run: () => pasteAt(place) },
    {
      title: 'Add a note here',
      run: () => editor.session.setState({ openNote: { x: Math.round(place.x), y: Math.round(place.y) } }),
    },
    ...[ofCommand(editor, 'edit.select-all'), ofCommand(editor, 'view.fit')],
  ];
}

/**
 * The menu of a place: for the object there, which is selected first, or for the empty place. @param by the device that opens it
 */
export function menuEntries(parts: MenuParts, place: Point): readonly MenuPart[] {
  const { context, level } = parts;
  const [hit] = hitsOf(context, { place, by: 'mouse' });
  const isSelected =
    hit !== undefined && hitsOf(context, { place, by: 'mouse' }).some(({ key }) => level.selection.keys().includes(key));
  if (hit !== undefined && !isSelected) clickAt(context, { place, by: 'mouse' }, false);
  const here = [...thingsHere(parts, place), ...unlockHere(parts, place)];
  return [
    ...here,
    ...(here.length > 0 ? [null] : []),
    ...(hit === undefined ? [] : [...forSelection(parts), null]),
    ...forPlace(parts, place),
  ];
}
