import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import { type Goal, mineralsNeeded, proofPicture } from '../../../solver/index.ts';
import type { EditedLevel } from '../../document/index.ts';
import type { ProofStore } from '../../proof/index.ts';
import type { SessionStore } from '../../session/index.ts';
import type { JobEnd, Results, Solving, Workers } from '../../workers/index.ts';
import { createCandidateGhosts } from './candidate-ghosts.ts';
import { type Found, foundBy, triedIn } from './found-runs.ts';
import type { GhostShelf } from './ghost-shelf.ts';
import { addFound, replaceByFound, SOLUTION } from './keep-found-run.ts';
import type { OverlayStore } from './overlay.ts';
import { type SearchJobs, startSearchJobs } from './search-jobs.ts';
import { aimOf, goalOf, type SearchSettingsStore } from './search-settings.ts';
import { afterChange, IDLE, type SearchState } from './search-state.ts';

/** ms after a change of the level before found runs are tried in it */
const SETTLE = 200;

/** The search for runs of one level. */
export interface SearchSession {
  readonly store: StoreApi<SearchState>;
  /** Looks for runs, from the start. */
  start(): void;
  /** Stops; what was found stays. */
  cancel(): void;
  /** Puts away what was found. */
  clear(): void;
  /** Shows this one alone on the canvas; null: all of them. */
  hover(id: string | null): void;
  /**
   * Puts a run into the level and shows it. Where no run completes the level and this one does, it comes first: it is the proof.
   * @param into name of the run whose place it takes; a new one when left out
   * @param as what a new run is called; by what it was looked for when left out
   */
  use(holds: readonly Hold[], into?: string, as?: string): void;
  close(): void;
}

export interface SearchParts {
  readonly level: GhostShelf & { readonly document: EditedLevel; readonly proof: ProofStore };
  readonly session: SessionStore;
  readonly workers: Pick<Workers, 'start'>;
  readonly settings: SearchSettingsStore;
  readonly overlay: OverlayStore;
  /** A clock, ms. */
  readonly now: () => number;
}

/** The search of a level: its jobs, what it has found, its ghosts and what it draws. */
export function createSearchSession({ level, session, workers, settings, overlay, now }: SearchParts): SearchSession {
  const { document, proof } = level;
  const store = createStore<SearchState>(() => IDLE);
  const ghosts = createCandidateGhosts(level);
  let jobs: SearchJobs | null = null;
  let began = 0;
  // what was searched: another scene is another level
  let scene: Scene | null = null;
  let goal: Goal = { minerals: 'any' };
  let timer: ReturnType<typeof setTimeout> | null = null;
  // what was found while one was pointed at: the list stands still under the pointer
  let unseen: readonly Found[] | null = null;

  const stopJobs = () => {
    jobs?.cancel();
    jobs = null;
  };
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
  const showProved = (searched: Level, { impossible, minerals }: Results['proofs']) => {
    const shown = impossible ?? minerals[0]?.proof ?? null;
    const count = searched.minerals.length;
    // more minerals are asked for than can be had
    const isHopeless = mineralsNeeded(goal, count) > count - minerals.length;
    store.setState({ impossible, mineralProofs: minerals, isHopeless });
    overlay.setState({ proof: shown === null ? null : proofPicture(searched, shown) });
    if ((impossible === null && !isHopeless) || store.getState().phase !== 'running') return;
    // nothing is left to look for
    jobs?.cancelSolving();
    store.setState({ phase: 'done', ms: now() - began });
    drawGhosts();
  };
  const showEnd = (end: JobEnd<'solve'>) => {
    if (end.kind === 'failed' || end.kind === 'gaveUp') store.setState({ phase: 'failed', message: end.message });
    else if (store.getState().phase === 'running') store.setState({ phase: end.kind, ms: now() - began });
  };

  /** The level has changed: the search is about another one, and what it found is tried in this one. */
  const recheck = () => {
    timer = null;
    const { scene: changed } = proof.proof();
    if (scene === null || changed === scene) return;
    stopJobs();
    scene = changed;
    unseen = null;
    const state = store.getState();
    store.setState(afterChange(state, triedIn(changed, goal, state.found)));
    overlay.setState({ heat: null, proof: null });
    drawGhosts();
  };
  const stopFollowing = proof.store.subscribe(({ scene: current }) => {
    if (scene === null || current === scene) return;
    if (timer !== null) clearTimeout(timer);
    timer = setTimeout(recheck, SETTLE);
  });

  /** What a run that was found is called in the level. */
  const nameOf = (holds: readonly Hold[]): string => {
    const { settings: asked, found } = store.getState();
    const rank = found.findIndex(({ id }) => id === holds.join());
    return asked === null || rank < 0 ? SOLUTION : aimOf(asked, rank + 1);
  };

  return {
    store,
    start() {
      stopJobs();
      unseen = null;
      began = now();
      const { level: searched, accuracy, scene: current } = proof.proof();
      const asked = settings.getState();
      scene = current;
      goal = goalOf(asked, searched.minerals.length);
      store.setState({ ...IDLE, phase: 'running', settings: asked });
      overlay.setState({ heat: null, proof: null });
      ghosts.clear();
      const task = { level: searched, accuracy, goal, settings: asked };
      const onProved = (proved: Results['proofs']) => showProved(searched, proved);
      jobs = startSearchJobs(workers, task, { onFound: showFound, onProved, onEnd: showEnd });
    },
    cancel() {
      if (store.getState().phase !== 'running') return;
      stopJobs();
      store.setState({ phase: 'cancelled', ms: now() - began });
    },
    clear() {
      stopJobs();
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
      if (timer !== null) clearTimeout(timer);
      stopJobs();
    },
  };
}
