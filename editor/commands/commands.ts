/** Something a person can do, by its name in the palette and by its keys. */
export interface Command {
  /** `group.verb`, unique */
  readonly id: string;
  readonly title: string;
  readonly group: 'File' | 'Edit' | 'Object' | 'View' | 'Run' | 'Play' | 'Solve' | 'Help';
  /** Key bindings in the notation of tinykeys: `$mod+z`, `Shift+Space`, `?`. The first one is shown. */
  readonly keys?: readonly string[];
  /** In which mode its keys work; `edit` when left out. */
  readonly mode?: 'edit' | 'play' | 'both';
  /** Whether its keys work while a text field has the focus, too. */
  readonly inText?: boolean;
  /** Not in the palette: a variant that only a key makes sense for. */
  readonly hidden?: boolean;
  /** Whether it can be done now; always when left out. */
  readonly enabled?: () => boolean;
  readonly run: () => void;
}

/** All commands, from whoever offers them while it is there. */
export interface Commands {
  /** @returns takes them away again */
  register(commands: readonly Command[]): () => void;
  all(): readonly Command[];
  /** Does it if it is there and enabled. @returns whether it was done */
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
      if (command === undefined || command.enabled?.() === false) return false;
      command.run();
      return true;
    },
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
