/** What `localStorage` offers, as far as the game needs it. */
export interface Store {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
}

/** Which runs are shown beside the play. */
export type GhostChoice = 'best' | 'all' | 'none';
export const GHOST_CHOICES: readonly GhostChoice[] = ['best', 'all', 'none'];

export interface Settings {
  muted: boolean;
  ghosts: GhostChoice;
  /** Whether every level can be played, not only those up to the first that is not completed. */
  allUnlocked: boolean;
}

/** The storage of the browser; memory if the browser refuses it, as in some private windows or when the disk is full. */
export class SafeStore implements Store {
  private readonly memory = new Map<string, string>();

  /** @param onRefusal called once, when nothing can be kept */
  constructor(private onRefusal: (() => void) | null) {}

  getItem(key: string): string | null {
    const inMemory = this.memory.get(key);
    if (inMemory !== undefined) return inMemory;
    try {
      return localStorage.getItem(key);
    } catch {
      this.refused();
      return null;
    }
  }

  setItem(key: string, value: string): void {
    try {
      localStorage.setItem(key, value);
      this.memory.delete(key);
    } catch {
      this.memory.set(key, value);
      this.refused();
    }
  }

  private refused(): void {
    const { onRefusal } = this;
    this.onRefusal = null;
    onRefusal?.();
  }
}

/** Packs on one host share its storage, so each page has keys of its own. */
export const keyOf = (what: string): string => `gravity-quest:${location.pathname.replace(/index\.html$/, '')}:${what}`;

/** Reads the settings; each change is stored at once. */
export function readSettings(store: Store): Settings {
  const key = keyOf('settings');
  const settings: Settings = { muted: false, ghosts: 'best', allUnlocked: false };
  try {
    const kept = JSON.parse(store.getItem(key) ?? '{}') as Partial<Settings> | null;
    if (typeof kept?.muted === 'boolean') settings.muted = kept.muted;
    if (typeof kept?.allUnlocked === 'boolean') settings.allUnlocked = kept.allUnlocked;
    if (GHOST_CHOICES.includes(kept?.ghosts as GhostChoice)) settings.ghosts = kept?.ghosts as GhostChoice;
  } catch {
    // damaged settings are as good as none
  }
  return new Proxy(settings, {
    set(target, name, value) {
      Object.assign(target, { [name]: value });
      store.setItem(key, JSON.stringify(target));
      return true;
    },
  });
}
