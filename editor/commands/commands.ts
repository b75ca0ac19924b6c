/** Something a person can do, by its name in the palette and by its keys. */
export interface Command {
  /** `group.verb`, unique */
  readonly id: string;
  readonly title: string;
  readonly group: 'File' | 'Edit' | 'Crosshair' | 'Object' | 'View' | 'Run' | 'Play' | 'Solve' | 'Help';
  /** Key bindings in the notation of tinykeys: `$mod+z`, `Shift+Space`, `?`. The first one is shown. */
  readonly keys?: readonly string[];
  /** In which mode its keys work; `edit` when left out. */
  readonly mode?: 'edit' | 'play' | 'both';
  /** Whether its keys work while a text field has the focus, too. */
  readonly inText?: boolean;
  /** Whether its keys work while a dialog or a menu lies over the page, too. */
  readonly inDialogs?: boolean;
  /** Not in the palette: a variant that only a key makes sense for. */
  readonly hidden?: boolean;
  /** What must be done before it can be done, as `select an object`; null when it can be done now, as always when left out. */
  readonly needs?: () => string | null;
  /** @param press the key by which it was called; undefined: by its name */
  readonly run: (press?: KeyboardEvent) => void;
}

/** What must be done before a command can be done; null when it can be done now. */
export const needsOf = ({ needs }: Command): string | null => needs?.() ?? null;

/** All commands, from whoever offers them while it is there. */
export interface Commands {
  /** @returns takes them away again */
  register(commands: readonly Command[]): () => void;
  all(): readonly Command[];
  /** Does it if it is there and needs nothing. @returns whether it was done */
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
