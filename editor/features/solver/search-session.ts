import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type Goal, mineralsNeeded, proofPicture } from '../../../solver/index.ts';
import type { Desk } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import type { SessionStore } from '../../core/session/index.ts';
import type { Proofs, Solving } from '../../workers/index.ts';
import { type Found, foundBy, triedIn } from './found-runs.ts';
import { createCandidateGhosts } from './ghosts.ts';
import { addFound, replaceByFound, SOLUTION } from './keep-found-run.ts';
import type { OverlayStore } from './overlay.ts';
import { aimOf, goalOf, type SearchSettingsStore } from './search-settings.ts';
import { afterChange, IDLE, type SearchState } from './search-state.ts';
import { createSearchJobs } from './search-task.ts';

/** ms without a change of the level before the runs that were found are checked in it */
const SETTLE = 200;

/** The search for runs of one level. */
export interface SearchSession {
  readonly store: StoreApi<SearchState>;
  /** Starts a new search. */
  start(): void;
  /** Stops the search and keeps the runs found. */
  cancel(): void;
  /** Discards the results. */
  clear(): void;
  /** Shows only this run on the canvas; null shows all. */
  hover(id: string | null): void;
  /**
   * Adds a run to the level and shows it. If no run completes the level and this one does, it becomes the first run.
   * @param into name of the run to replace; without it a run is added
   * @param as name of the new run; by default it describes the search settings
   */
  use(holds: readonly Hold[], into?: string, as?: string): void;
  close(): void;
}

export interface SearchParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof' | 'ghosts'>;
  readonly session: SessionStore;
  readonly desk: Desk;
  readonly settings: SearchSettingsStore;
  readonly overlay: OverlayStore;
  /** A clock, ms. */
  readonly now: () => number;
}

/** The search of a level: its jobs, results, ghosts and overlay. */
export function createSearchSession({ level, session, desk, settings, overlay, now }: SearchParts): SearchSession {
  const { document, proof } = level;
  const store = createStore<SearchState>(() => IDLE);
  const ghosts = createCandidateGhosts(level);
  const jobs = createSearchJobs(desk);
  let began = 0;
  // The scene that was searched; a change of the level makes another scene.
  let scene: Scene | null = null;
  let goal: Goal = { minerals: 'any' };
  let forget = () => {};
  // Results that arrived while the pointer is on one: the list must not move under the pointer.
  let unseen: readonly Found[] | null = null;

  const drawGhosts = () => {
    if (scene !== null) ghosts.draw(scene, store.getState());
  };

  const showFound = (solving: Solving) => {
    const found = foundBy(solving);
    const { hovered, found: listed } = store.getState();
    unseen = hovered === null ? null : found;
    store.setState({ solving, found: hovered === null ? found : listed, ms: now() - began });
    overlay.setState({ heat: solving.explored });
    drawGhosts();
  };
  const showProved = (searched: Level, { impossible, minerals }: Proofs) => {
    const shown = impossible ?? minerals[0]?.proof ?? null;
    const count = searched.minerals.length;
    // more minerals are wanted than can be collected
    const isHopeless = mineralsNeeded(goal, count) > count - minerals.length;
    store.setState({ impossible, mineralProofs: minerals, isHopeless });
    overlay.setState({ proof: shown === null ? null : proofPicture(searched, shown) });
    if ((impossible === null && !isHopeless) || store.getState().phase !== 'running') return;
    // nothing is left to find
    jobs.cancelSolving();
    store.setState({ phase: 'done', ms: now() - began });
    drawGhosts();
  };
  const showEnd = (failure: string | null) => {
    if (failure !== null) store.setState({ phase: 'failed', message: failure });
    else if (store.getState().phase === 'running') store.setState({ phase: 'done', ms: now() - began });
  };

  /** After a change of the level: stops the search and checks the runs found in the changed level. */
  const recheck = () => {
    const { scene: changed } = proof.proof();
    if (scene === null || changed === scene) return;
    jobs.cancel();
    scene = changed;
    unseen = null;
    const state = store.getState();
    store.setState(afterChange(state, triedIn(changed, goal, state.found)));
    overlay.setState({ heat: null, proof: null });
    drawGhosts();
  };
  const stopFollowing = proof.store.subscribe(({ scene: current }) => {
    if (scene === null || current === scene) return;
    forget();
    forget = desk.afterRest(SETTLE, recheck);
  });

  /** The name of a found run in the level. */
  const nameOf = (holds: readonly Hold[]): string => {
    const { settings: asked, found } = store.getState();
    const rank = found.findIndex(({ id }) => id === holds.join());
    return asked === null || rank < 0 ? SOLUTION : aimOf(asked, rank + 1);
  };

  return {
    store,
    start() {
      jobs.cancel();
      unseen = null;
      began = now();
      const { level: searched, terms, scene: current } = proof.proof();
      const asked = settings.getState();
      scene = current;
      goal = goalOf(asked, searched.minerals.length);
      store.setState({ ...IDLE, phase: 'running', settings: asked });
      overlay.setState({ heat: null, proof: null });
      ghosts.clear();
      const task = { level: searched, terms, goal, settings: asked };
      const onProved = (proved: Proofs) => showProved(searched, proved);
      jobs.start(task, { onFound: showFound, onProved, onEnd: showEnd });
    },
    cancel() {
      if (store.getState().phase !== 'running') return;
      jobs.cancel();
      store.setState({ phase: 'cancelled', ms: now() - began });
    },
    clear() {
      jobs.cancel();
      scene = null;
      unseen = null;
      store.setState(IDLE);
      overlay.setState({ heat: null, proof: null });
      ghosts.clear();
    },
    hover(id) {
      if (store.getState().hovered === id) return;
      const { found } = store.getState();
      store.setState({ hovered: id, found: id === null ? (unseen ?? found) : found });
      if (id === null) unseen = null;
      drawGhosts();
    },
    use(holds, into, as) {
      const parts = { document, proof, session };
      if (into !== undefined) replaceByFound(parts, holds, into);
      else addFound(parts, holds, as ?? nameOf(holds));
    },
    close() {
      stopFollowing();
      forget();
      jobs.cancel();
    },
  };
}
