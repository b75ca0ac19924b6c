import { createStore, type StoreApi } from 'zustand/vanilla';

/** Something the person should know, shown at the side and read out. */
export interface Notice {
  readonly id: number;
  readonly severity: 'info' | 'warning' | 'error';
  readonly text: string;
  /** What can be done about it, as buttons. */
  readonly actions: readonly { readonly title: string; readonly run: () => void }[];
  /** A notice with the same topic takes the place of the last one. */
  readonly topic: string | null;
}

export interface Notices {
  readonly store: StoreApi<readonly Notice[]>;
  show(severity: Notice['severity'], text: string, options?: { actions?: Notice['actions']; topic?: string }): number;
  dismiss(id: number): void;
  /** Takes the notice about a topic away: what it said is no longer so. */
  settle(topic: string): void;
}

export function createNotices(): Notices {
  const store = createStore<readonly Notice[]>(() => []);
  let last = 0;
  const keep = (test: (notice: Notice) => boolean) => {
    const left = store.getState().filter(test);
    if (left.length !== store.getState().length) store.setState(left, true);
  };
  return {
    store,
    show(severity, text, { actions = [], topic = null } = {}) {
      const notice: Notice = { id: ++last, severity, text, actions, topic };
      const others = store.getState().filter((other) => topic === null || other.topic !== topic);
      store.setState([...others, notice], true);
      return notice.id;
    },
    dismiss: (id) => keep((notice) => notice.id !== id),
    settle: (topic) => keep((notice) => notice.topic !== topic),
  };
}
