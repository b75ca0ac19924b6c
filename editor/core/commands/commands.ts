/** A button of a gamepad with a name; the stick counts as the directions. */
export type PadButton = 'A' | 'Select' | 'Start' | 'Up' | 'Down' | 'Left' | 'Right';

/** An action that can be started from the palette, with its keys, or with a button of a gamepad. */
export interface Command {
  /** `group.verb`, unique */
  readonly id: string;
  readonly title: string;
  readonly group: 'File' | 'Edit' | 'Crosshair' | 'Object' | 'View' | 'Run' | 'Play' | 'Solve' | 'Help';
  /** Key bindings in the notation of tinykeys: `$mod+z`, `Shift+Space`, `?`. The first one is shown. */
  readonly keys?: readonly string[];
  /** The button of a gamepad that starts it. */
  readonly pad?: PadButton;
  /** The mode in which its keys and button work; `edit` if absent. */
  readonly mode?: 'edit' | 'play' | 'both';
  /** Whether its keys also work while a text field has the focus. */
  readonly inText?: boolean;
  /** Whether its keys also work while a dialog or a menu covers the page. */
  readonly inDialogs?: boolean;
  /** Not in the palette: a variant that only makes sense with a key. */
  readonly hidden?: boolean;
  /** What must be done first, for example `select an object`; null or absent if the command can run now. */
  readonly needs?: () => string | null;
  /** @param press the key event that started it; undefined when started by name */
  readonly run: (press?: KeyboardEvent) => void;
}

/** What must be done before the command can run; null if it can run now. */
export const needsOf = ({ needs }: Command): string | null => needs?.() ?? null;

/** All commands that are registered at the moment. */
export interface Commands {
  /** @returns removes them again */
  register(commands: readonly Command[]): () => void;
  all(): readonly Command[];
  /** Runs the command if it is registered and needs nothing first. @returns whether it ran */
  run(id: string): boolean;
  subscribe(listener: () => void): () => void;
}

export function createCommands(): Commands {
  const byId = new Map<string, Command>();
  const listeners = new Set<() => void>();
  let list: readonly Command[] = [];

  const changed = () => {
    list = [...byId.values()];
    for (const listener of listeners) listener();
  };
  return {
    register(commands) {
      for (const command of commands) byId.set(command.id, command);
      changed();
      return () => {
        for (const command of commands) if (byId.get(command.id) === command) byId.delete(command.id);
        changed();
      };
    },
    all: () => list,
    run(id) {
      const command = byId.get(id);
      if (command === undefined || needsOf(command) !== null) return false;
      command.run();
      return true;
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}

/** A level, run, object or rule that the palette can go to. */
export interface Destination {
  /** unique */
  readonly key: string;
  readonly group: 'Level' | 'Run' | 'Object' | 'Rule';
  readonly title: string;
  /** Distinguishes it from others of the same name. */
  readonly detail: string;
  readonly go: () => void;
}

/** At most this many of a list are offered; another typed letter narrows it. */
const MOST = 12;

/** Destinations that contain every word of the query; none while the query is empty. @param lists is read if there is a query */
export function findDestinations(lists: () => readonly (readonly Destination[])[], query: string): readonly Destination[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const isFound = ({ group, title, detail }: Destination) => {
    const text = `${group} ${title} ${detail}`.toLowerCase();
    return words.every((word) => text.includes(word));
  };
  return lists().flatMap((list) => list.filter(isFound).slice(0, MOST));
}
