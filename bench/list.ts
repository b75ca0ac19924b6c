import type { Bench } from './harness/index.ts';

/** A file with a benchmark in it. */
interface File {
  // what it is told and what it claims is known to the file alone
  readonly bench: Bench;
}

/** All benchmarks by their names; each is loaded when it is asked for. */
export const BENCHES: Readonly<Record<string, () => Promise<File>>> = {
  accuracy: () => import('./accuracy.ts'),
  alive: () => import('./alive.ts'),
  arcade: () => import('./arcade.ts'),
  asteroids: () => import('./asteroids.ts'),
  balance: () => import('./balance.ts'),
  cache: () => import('./cache.ts'),
  chains: () => import('./chains.ts'),
  check: () => import('./check.ts'),
  decided: () => import('./decided.ts'),
  diff: () => import('./diff.ts'),
  difficulty: () => import('./difficulty.ts'),
  editor: () => import('./editor.ts'),
  'editor-soak': () => import('./editor-soak.ts'),
  effects: () => import('./effects.ts'),
  example: () => import('./example.ts'),
  'fleet-model': () => import('./fleet-model.ts'),
  growth: () => import('./growth.ts'),
  mutation: () => import('./mutation.ts'),
  packs: () => import('./packs.ts'),
  peers: () => import('./peers.ts'),
  player: () => import('./player.ts'),
  proofs: () => import('./proofs.ts'),
  robust: () => import('./robust.ts'),
  runs: () => import('./runs.ts'),
  soak: () => import('./soak.ts'),
  solve: () => import('./solve.ts'),
  startup: () => import('./startup.ts'),
  throughput: () => import('./throughput.ts'),
  tune: () => import('./tune.ts'),
  variety: () => import('./variety.ts'),
  verify: () => import('./verify.ts'),
};
