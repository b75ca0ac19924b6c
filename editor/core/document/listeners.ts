/** The listeners for events of one kind. */
export interface Listeners<E> {
  /** @returns removes it */
  add(listener: (event: E) => void): () => void;
  /** Calls all current listeners. */
  call(event: E): void;
}

export function createListeners<E>(): Listeners<E> {
  const all = new Set<(event: E) => void>();
  return {
    add(listener) {
      all.add(listener);
      return () => all.delete(listener);
    },
    call(event) {
      for (const listener of [...all]) listener(event);
    },
  };
}
