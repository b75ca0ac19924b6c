import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Explored, ProofPicture } from '../../../solver/index.ts';

/** What a search has to show on the canvas besides ways. */
export interface SearchOverlay {
  /** Where it has been; null before the first search. The layer `heatMap` shows it. */
  readonly heat: Explored | null;
  /** Why the black hole, or a mineral, is out of reach; null where nothing was proved. */
  readonly proof: ProofPicture | null;
}

export type OverlayStore = StoreApi<SearchOverlay>;

export const createOverlay = (): OverlayStore => createStore<SearchOverlay>(() => ({ heat: null, proof: null }));
