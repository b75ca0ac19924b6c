import { defaultFilter, Command as Palette } from 'cmdk';
import { Dialog as Radix } from 'radix-ui';
import { useEffect, useState, useSyncExternalStore } from 'react';
import { flushSync } from 'react-dom';
import { type Command, keyLabel, needsOf } from '../commands/index.ts';
import { IS_MAC, useEditor, useSession } from '../context/index.ts';
import { type Destination, findDestinations } from './palette-destinations.ts';

/** A line of the palette. */
interface Entry {
  readonly key: string;
  readonly title: string;
  readonly group: string;
  /** Keys of a command, or what tells a place from others. */
  readonly aside: string | null;
  /** What must be done first; null when it can be done. */
  readonly needs: string | null;
  readonly go: () => void;
}

/** Below this a name has the letters of the query, but scattered. */
const LEAST_SCORE = 0.02;

/** Of names that match equally well the shortest comes first: `dupl` means Duplicate, not Duplicate this level. */
function rank({ title, group, aside }: Entry, query: string): number {
  return defaultFilter(title, query, [group, aside ?? '']) * (1 - 1e-4 * Math.min(100, title.length));
}

function commandEntry(command: Command, run: (id: string) => void): Entry {
  const { id, title, group, keys } = command;
  const aside = keys?.[0] === undefined ? null : keyLabel(keys[0], IS_MAC);
  return { key: id, title, group, aside, needs: needsOf(command), go: () => run(id) };
}

const destinationEntry = ({ key, title, group, detail, go }: Destination): Entry => ({
  key,
  title,
  group,
  aside: detail,
  needs: null,
  go,
});

/**
 * Every command that can be done by its group, as long as nothing is typed; then commands, levels, runs and objects, the best
 * match first, and after them the commands that need something first, with what that is.
 */
export function CommandPalette() {
  const editor = useEditor();
  const { commands, session } = editor;
  const open = useSession((state) => state.overlay === 'palette');
  const all = useSyncExternalStore(commands.subscribe, commands.all);
  const [query, setQuery] = useState('');
  useEffect(() => {
    if (open) setQuery('');
  }, [open]);

  const offered = open ? all.filter(({ hidden }) => hidden !== true) : [];
  const entries = offered.map((command) => commandEntry(command, commands.run));
  const usable = entries.filter(({ needs }) => needs === null);
  const typed = query.trim();
  const found = [...entries, ...(open ? findDestinations(editor, typed).map(destinationEntry) : [])]
    .map((entry) => ({ entry, score: rank(entry, typed) }))
    .filter(({ score }) => score > LEAST_SCORE)
    .sort((a, b) => Number(a.entry.needs !== null) - Number(b.entry.needs !== null) || b.score - a.score)
    .map(({ entry }) => entry);
  const show = (entry: Entry, withGroup: boolean) => (
    <Palette.Item
      key={entry.key}
      value={entry.key}
      className="palette__item"
      disabled={entry.needs !== null}
      onSelect={() => {
        // gone before it is done: what is done may give the focus to something, which an open dialog would take back
        flushSync(() => session.setState({ overlay: null }));
        entry.go();
      }}
    >
      <span>{entry.title}</span>
      {withGroup && <span className="palette__group">{entry.needs ?? entry.group}</span>}
      {entry.aside !== null && <kbd>{entry.aside}</kbd>}
    </Palette.Item>
  );
  return (
    <Radix.Root open={open} onOpenChange={(next) => session.setState({ overlay: next ? 'palette' : null })}>
      <Radix.Portal>
        <Radix.Overlay className="dialog__shade" />
        <Radix.Content
          className="palette__frame"
          aria-describedby={undefined}
          onCloseAutoFocus={(event) => {
            if (document.activeElement !== document.body) event.preventDefault();
          }}
        >
          <Radix.Title className="unseen">Commands</Radix.Title>
          <Palette
            className="palette"
            label="Commands"
            // it orders within groups only
            shouldFilter={false}
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
                ? [...new Set(usable.map(({ group }) => group))].map((group) => (
                    <Palette.Group key={group} heading={group}>
                      {usable.filter((entry) => entry.group === group).map((entry) => show(entry, false))}
                    </Palette.Group>
                  ))
                : found.map((entry) => show(entry, true))}
            </Palette.List>
          </Palette>
        </Radix.Content>
      </Radix.Portal>
    </Radix.Root>
  );
}
