import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Scene } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';
import {
  type Candidate,
  type Explored,
  type Goal,
  mineralsNeeded,
  type Proof,
  type ProofPicture,
  verifyRun,
} from '../../../solver/index.ts';
import type { Desk } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { addRun, type EditedLevel, freeRunName, replaceHolds } from '../../core/document/index.ts';
import type { ProofStore } from '../../core/proof/index.ts';
import type { SessionStore } from '../../core/session/index.ts';
import type { Proofs, Solving } from '../../workers/index.ts';
import { createCandidateGhosts } from './ghosts.ts';
import { aimOf, createSearchJobs, goalOf, type SearchSettings, type SearchSettingsStore } from './search-task.ts';

/** ms without a change of the level before the runs that were found are checked in it */
const REST = 200;

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

interface SearchParts {
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
  const showProved = ({ minerals: { length: count } }: Level, { impossible, minerals, picture = null }: Proofs) => {
    // more minerals are wanted than can be collected
    const isHopeless = mineralsNeeded(goal, count) > count - minerals.length;
    store.setState({ impossible, mineralProofs: minerals, isHopeless });
    overlay.setState({ proof: picture });
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
    forget = desk.afterRest(REST, recheck);
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

// the state of a search

/** The state of a level's search. */
export interface SearchState {
  /** `stale`: it was stopped because the level changed */
  readonly phase: 'idle' | 'running' | 'done' | 'cancelled' | 'stale' | 'failed';
  /** the message of a failure */
  readonly message: string | null;
  /** ms spent */
  readonly ms: number;
  /** The settings of the search; null before the first one. */
  readonly settings: SearchSettings | null;
  readonly solving: Solving | null;
  /** best first */
  readonly found: readonly Found[];
  readonly impossible: Proof | null;
  readonly mineralProofs: Proofs['minerals'];
  /** Whether it is proved that the wanted minerals can't all be collected. */
  readonly isHopeless: boolean;
  /** Whether the level has changed since the search. */
  readonly isOld: boolean;
  /** id of the run under the pointer */
  readonly hovered: string | null;
}

/**
 * The state after a change of the level: only the runs that were found still count. @param found those runs, checked in the
 * current level
 */
const afterChange = ({ phase }: SearchState, found: readonly Found[]): Partial<SearchState> => ({
  found,
  impossible: null,
  mineralProofs: [],
  isHopeless: false,
  isOld: true,
  solving: null,
  phase: phase === 'running' ? 'stale' : phase,
});

/** Before the first search. */
const IDLE: SearchState = {
  phase: 'idle',
  message: null,
  ms: 0,
  settings: null,
  solving: null,
  found: [],
  impossible: null,
  mineralProofs: [],
  isHopeless: false,
  isOld: false,
  hovered: null,
};

// runs that were found, and runs of the level that are made of them

/** A run that a search found, and whether it still meets the goal. */
export interface Found {
  /** equal for equal holds */
  readonly id: string;
  readonly candidate: Candidate;
  /** Success with timing noise of 40 ms, 0 to 1; null if not measured. */
  readonly p40: number | null;
  readonly certified: boolean;
  /** False if the level has changed and the run now fails. */
  readonly works: boolean;
}

/** The runs that a search has found so far, best first. */
const foundBy = ({ solutions }: Solving): Found[] =>
  solutions.map((solution) => ({
    id: solution.holds.join(),
    candidate: solution,
    p40: solution.p40?.p ?? null,
    certified: solution.certified,
    works: true,
  }));

/** Checks runs that were found in another state of the level. */
const triedIn = (scene: Scene, goal: Goal, found: readonly Found[]): Found[] =>
  found.map((one) => {
    const verified = verifyRun(scene, one.candidate.holds, goal);
    // the success was measured in the previous state of the level
    return { ...one, candidate: verified ?? one.candidate, works: verified !== null, p40: null, certified: false };
  });

/** The name of the first run that completes the level. */
export const SOLUTION = 'solution';

interface KeepParts {
  readonly document: EditedLevel;
  readonly proof: ProofStore;
  readonly session: SessionStore;
}

/** Replaces a run of the level and shows it. @param name of the run to replace */
function replaceByFound({ document, session }: KeepParts, holds: readonly Hold[], name: string): void {
  document.change(`Replace run ${name}`, replaceHolds(name, holds));
  session.setState({ run: name });
}

/**
 * Adds a run to the level and shows it. If no run completes the level and this one does, it becomes the first run.
 * @param wanted its name, unless it is the first run that completes the level
 */
function addFound({ document, proof, session }: KeepParts, holds: readonly Hold[], wanted: string): void {
  const file = document.file();
  const { provenBy, scene } = proof.proof();
  // The first run is the one in pictures; a run that fails in the current level must not become it.
  const proves = provenBy === null && verifyRun(scene, holds) !== null;
  const hasSolution = file.runs?.some(({ name }) => name === SOLUTION) === true;
  const name = freeRunName(file, proves && !hasSolution ? SOLUTION : wanted);
  if (document.change(`Add run ${name}`, addRun(name, holds, proves ? 'first' : 'last')).ok) session.setState({ run: name });
}

// what a search shows on the canvas besides paths

/** What a search shows on the canvas besides paths. */
export interface SearchOverlay {
  /** Where the search has been; null before the first search. The layer `heatMap` shows it. */
  readonly heat: Explored | null;
  /** Why the black hole or a mineral is out of reach; null if nothing is proved. */
  readonly proof: ProofPicture | null;
}

export type OverlayStore = StoreApi<SearchOverlay>;

export const createOverlay = (): OverlayStore => createStore<SearchOverlay>(() => ({ heat: null, proof: null }));
