import { createStore, type StoreApi } from 'zustand/vanilla';

/** A message to the user, shown in a corner and read out. */
export interface Notice {
  readonly id: number;
  readonly severity: 'info' | 'warning' | 'error';
  readonly text: string;
  /** Actions offered as buttons. */
  readonly actions: readonly { readonly title: string; readonly run: () => void }[];
  /** A notice replaces the previous notice with the same topic. */
  readonly topic: string | null;
}

export interface Notices {
  readonly store: StoreApi<readonly Notice[]>;
  show(severity: Notice['severity'], text: string, options?: { actions?: Notice['actions']; topic?: string }): number;
  /** Says why a change of the level was refused, and what to do. */
  refuse(refusal: { readonly message: string; readonly hint: string }): void;
  dismiss(id: number): void;
  /** Removes the notice about a topic: what it said no longer holds. */
  clear(topic: string): void;
}

export function createNotices(): Notices {
  const store = createStore<readonly Notice[]>(() => []);
  let last = 0;
  const keep = (test: (notice: Notice) => boolean) => {
    const left = store.getState().filter(test);
    if (left.length !== store.getState().length) store.setState(left, true);
  };
  const show: Notices['show'] = (severity, text, { actions = [], topic = null } = {}) => {
    const notice: Notice = { id: ++last, severity, text, actions, topic };
    const others = store.getState().filter((other) => topic === null || other.topic !== topic);
    store.setState([...others, notice], true);
    return notice.id;
  };
  return {
    store,
    show,
    refuse: ({ message, hint }) => void show('warning', `${message}. ${hint}`, { topic: 'refused' }),
    dismiss: (id) => keep((notice) => notice.id !== id),
    clear: (topic) => keep((notice) => notice.topic !== topic),
  };
}
