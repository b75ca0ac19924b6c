import { defaultFilter, Command as Palette } from 'cmdk';
import { Dialog as Radix } from 'radix-ui';
import { useEffect, useState, useSyncExternalStore } from 'react';
import { flushSync } from 'react-dom';
import { type Command, type Destination, findDestinations, keyLabel, needsOf } from '../core/commands/index.ts';
import { IS_MAC, useEditor, useSession } from '../core/context/index.ts';
import { FEATURES } from '../features/index.ts';

/** A line of the palette. */
interface Entry {
  readonly key: string;
  readonly title: string;
  readonly group: string;
  /** The keys of a command, or the detail of a destination. */
  readonly aside: string | null;
  /** What must be done first; null if it can be done now. */
  readonly needs: string | null;
  readonly go: () => void;
}

/** Below this score, a name contains the letters of the query only scattered. */
const LEAST_SCORE = 0.02;

/** Of names that match equally well, the shortest comes first: `dupl` finds Duplicate before Duplicate this level. */
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
 * While nothing is typed: the commands that can be used now, by group. Otherwise commands, levels, runs, objects and rules,
 * best match first, followed by the commands that need something else first, with what that is.
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
  const found = [
    ...entries,
    ...(open
      ? findDestinations(() => FEATURES.map(({ destinations }) => destinations?.(editor) ?? []), typed).map(destinationEntry)
      : []),
  ]
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
        // Closed before the command runs: the command may set the focus, which an open dialog would take back.
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
            // cmdk's own filter orders only within groups.
            shouldFilter={false}
          >
            <Palette.Input
              className="palette__input"
              placeholder="Search commands, levels, runs, objects and rules"
              value={query}
              onValueChange={setQuery}
            />
            <Palette.List className="palette__list">
              <Palette.Empty className="palette__empty">No results.</Palette.Empty>
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
