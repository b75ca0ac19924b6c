import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Explored, ProofPicture } from '../../../solver/index.ts';

/** What a search shows on the canvas besides paths. */
export interface SearchOverlay {
  /** Where the search has been; null before the first search. The layer `heatMap` shows it. */
  readonly heat: Explored | null;
  /** Why the black hole or a mineral is out of reach; null if nothing is proved. */
  readonly proof: ProofPicture | null;
}

export type OverlayStore = StoreApi<SearchOverlay>;

export const createOverlay = (): OverlayStore => createStore<SearchOverlay>(() => ({ heat: null, proof: null }));
