import type { JobKind } from '../protocol.ts';
import type { Start } from '../work.ts';
import { accuracy } from './accuracy.ts';
import { check } from './check.ts';
import { compare } from './compare.ts';
import { difficulty } from './difficulty.ts';
import { fan } from './fan.ts';
import { fix } from './fix.ts';
import { grade } from './grade.ts';
import { leeway } from './leeway.ts';
import { losses, lost } from './lost.ts';
import { mend } from './mend.ts';
import { path } from './path.ts';
import { plays } from './plays.ts';
import { proofs } from './proofs.ts';
import { retime } from './retime.ts';
import { robustness } from './robustness.ts';
import { slack } from './slack.ts';
import { solve } from './solve.ts';
import { thumbnail } from './thumbnail.ts';
import { trajectory } from './trajectory.ts';

/** All jobs of a worker. */
export const JOBS: { readonly [K in JobKind]: Start<K> } = {
  solve,
  robustness,
  fan,
  slack,
  difficulty,
  grade,
  proofs,
  accuracy,
  check,
  fix,
  mend,
  thumbnail,
  compare,
  plays,
  lost,
  losses,
  leeway,
  retime,
  path,
  trajectory,
};
