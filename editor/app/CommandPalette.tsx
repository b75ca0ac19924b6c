import { defaultFilter, Command as Palette } from 'cmdk';
import { useEffect, useState, useSyncExternalStore } from 'react';
import { type Command, keyLabel } from '../commands/index.ts';
import { useEditor, useSession } from './context.ts';
import { findPlaces, type Place } from './palette-places.ts';
import { IS_MAC } from './platform.ts';

/** A line of the palette. */
interface Entry {
  readonly key: string;
  readonly title: string;
  readonly group: string;
  /** Keys of a command, or what tells a place from others. */
  readonly aside: string | null;
  readonly go: () => void;
}

/** Below this a name has the letters of the query, but scattered. */
const LEAST_SCORE = 0.02;

/** Of names that match equally well the shortest comes first: `dupl` means Duplicate, not Duplicate this level. */
function rank({ title, group, aside }: Entry, query: string): number {
  return defaultFilter(title, query, [group, aside ?? '']) * (1 - 1e-4 * Math.min(100, title.length));
}

const commandEntry = ({ id, title, group, keys }: Command, run: (id: string) => void): Entry => ({
  key: id,
  title,
  group,
  aside: keys?.[0] === undefined ? null : keyLabel(keys[0], IS_MAC),
  go: () => run(id),
});

const placeEntry = ({ key, title, group, detail, go }: Place): Entry => ({ key, title, group, aside: detail, go });

/** Every command by its group, as long as nothing is typed; then commands, levels, runs and objects, the best match first. */
export function CommandPalette() {
  const editor = useEditor();
  const { commands, session } = editor;
  const open = useSession((state) => state.overlay === 'palette');
  const all = useSyncExternalStore(commands.subscribe, commands.all);
  const [query, setQuery] = useState('');
  useEffect(() => {
    if (open) setQuery('');
  }, [open]);

  const usable = open ? all.filter((command) => command.hidden !== true && command.enabled?.() !== false) : [];
  const entries = usable.map((command) => commandEntry(command, commands.run));
  const typed = query.trim();
  const found = [...entries, ...(open ? findPlaces(editor, typed).map(placeEntry) : [])]
    .map((entry) => ({ entry, score: rank(entry, typed) }))
    .filter(({ score }) => score > LEAST_SCORE)
    .sort((a, b) => b.score - a.score)
    .map(({ entry }) => entry);
  const show = (entry: Entry, withGroup: boolean) => (
    <Palette.Item
      key={entry.key}
      value={entry.key}
      className="palette__item"
      onSelect={() => {
        session.setState({ overlay: null });
        entry.go();
      }}
    >
      <span>{entry.title}</span>
      {withGroup && <span className="palette__group">{entry.group}</span>}
      {entry.aside !== null && <kbd>{entry.aside}</kbd>}
    </Palette.Item>
  );
  return (
    <Palette.Dialog
      open={open}
      onOpenChange={(next) => session.setState({ overlay: next ? 'palette' : null })}
      label="Commands"
      // it orders within groups only
      shouldFilter={false}
      className="palette"
      overlayClassName="dialog__shade"
      contentClassName="palette__frame"
    >
      <Palette.Input
        className="palette__input"
        placeholder="What do you want to do, or where to?"
        value={query}
        onValueChange={setQuery}
      />
      <Palette.List className="palette__list">
        <Palette.Empty className="palette__empty">Nothing has this name.</Palette.Empty>
        {typed === ''
          ? [...new Set(entries.map(({ group }) => group))].map((group) => (
              <Palette.Group key={group} heading={group}>
                {entries.filter((entry) => entry.group === group).map((entry) => show(entry, false))}
              </Palette.Group>
            ))
          : found.map((entry) => show(entry, true))}
      </Palette.List>
    </Palette.Dialog>
  );
}
