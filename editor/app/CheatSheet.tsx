import { useSyncExternalStore } from 'react';
import { keyLabels } from '../core/commands/index.ts';
import { IS_MAC, useEditor, useOverlay } from '../core/context/index.ts';
import { Dialog } from '../core/ui/index.ts';

/** Pointer gestures, which are not commands. */
const POINTER: readonly (readonly [gesture: string, what: string])[] = [
  ['drag an object', 'move it and the rest of the selection'],
  ['drag its rim', 'change its radius'],
  ['double-click, Alt + click', 'select one member of a group'],
  ['click again at the same place', 'select what lies below'],
  ['right button, resting finger', 'open the menu of the place'],
  ['drag a handle of the box', 'scale the selection; with Shift freely, with Alt radii too'],
  ['drag the circle above the box', 'turn the selection; with Shift by steps of 15°'],
  ['double-click on a tool', 'keep it after placing'],
  ['drag a note', 'move it; click it to edit it'],
  ['drag in the minimap', 'move the view'],
  ['drag on empty space', 'select what lies inside'],
  ['Shift + click', 'add to the selection or remove from it'],
  ['Alt + drag', 'move a copy'],
  [`${IS_MAC ? '⌘' : 'Ctrl'} while dragging`, 'move without snapping'],
  ['drag with the middle or right button, two fingers', 'move the view'],
  ['wheel, pinch', 'zoom at the pointer'],
  ['drag a hold in the gun lane', 'move it; drag an end to stretch it'],
  ['Alt + drag in the gun lane', 'move everything after it as well'],
  ['A, B, X, Y, shoulders of a gamepad', 'hold the gun in a playtest'],
];

/** All keyboard shortcuts and gestures on one sheet. */
export function CheatSheet() {
  const { commands } = useEditor();
  const dialog = useOverlay('cheatSheet');
  const all = useSyncExternalStore(commands.subscribe, commands.all);
  const keyed = all.filter(({ keys }) => keys !== undefined && keys.length > 0);
  const groups = [...new Set(keyed.map(({ group }) => group))];
  return (
    <Dialog {...dialog} wide title="Shortcuts and gestures" about="Search (Ctrl K) finds every command.">
      <div className="sheet">
        {groups.map((group) => (
          <section key={group} className="sheet__group">
            <h3>{group}</h3>
            <dl>
              {keyed
                .filter((command) => command.group === group)
                .map(({ id, title, keys, pad }) => (
                  <div key={id} className="sheet__row">
                    <dt>{title}</dt>
                    <dd>
                      {keyLabels(keys ?? [], IS_MAC).map((label) => (
                        <kbd key={label}>{label}</kbd>
                      ))}
                      {pad !== undefined && <kbd>gamepad {pad}</kbd>}
                    </dd>
                  </div>
                ))}
            </dl>
          </section>
        ))}
        <section className="sheet__group">
          <h3>Pointer</h3>
          <dl>
            {POINTER.map(([gesture, what]) => (
              <div key={gesture} className="sheet__row">
                <dt>{what}</dt>
                <dd>{gesture}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </Dialog>
  );
}
