import { useSyncExternalStore } from 'react';
import { keyLabels } from '../commands/index.ts';
import { IS_MAC, useEditor, useSession } from '../context/index.ts';
import { Dialog } from '../ui/index.ts';

/** What the pointer does, which no command can say. */
const POINTER: readonly (readonly [gesture: string, what: string])[] = [
  ['drag an object', 'moves it, and all that is selected'],
  ['drag its rim', 'changes its radius'],
  ['drag on empty space', 'selects what lies inside'],
  ['Shift + click', 'adds to the selection or takes away'],
  ['Alt + drag', 'moves a copy'],
  [`${IS_MAC ? '⌘' : 'Ctrl'} while dragging`, 'no snapping'],
  ['middle or right button, two fingers', 'moves the view'],
  ['wheel, pinch', 'zooms to the pointer'],
  ['drag a bar in the gun lane', 'moves when the gun is held; its ends stretch it'],
  ['Alt + drag in the gun lane', 'moves all that follows as well'],
];

/** All keys and gestures on one sheet. */
export function CheatSheet() {
  const { commands, session } = useEditor();
  const open = useSession((state) => state.overlay === 'cheatSheet');
  const all = useSyncExternalStore(commands.subscribe, commands.all);
  const keyed = all.filter(({ keys }) => keys !== undefined && keys.length > 0);
  const groups = [...new Set(keyed.map(({ group }) => group))];
  return (
    <Dialog
      open={open}
      wide
      title="Keys and gestures"
      about="Every command is in the palette by its name, too."
      onClose={() => session.setState({ overlay: null })}
    >
      <div className="sheet">
        {groups.map((group) => (
          <section key={group} className="sheet__group">
            <h3>{group}</h3>
            <dl>
              {keyed
                .filter((command) => command.group === group)
                .map(({ id, title, keys }) => (
                  <div key={id} className="sheet__row">
                    <dt>{title}</dt>
                    <dd>
                      {keyLabels(keys ?? [], IS_MAC).map((label) => (
                        <kbd key={label}>{label}</kbd>
                      ))}
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
