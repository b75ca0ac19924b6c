import type { JobKind } from '../protocol.ts';
import type { Start } from '../work.ts';
import { accuracy } from './accuracy.ts';
import { check } from './check.ts';
import { difficulty } from './difficulty.ts';
import { fan } from './fan.ts';
import { fix } from './fix.ts';
import { generate } from './generate.ts';
import { losses, lost } from './lost.ts';
import { mend } from './mend.ts';
import { path } from './path.ts';
import { plays } from './plays.ts';
import { proofs } from './proofs.ts';
import { retime } from './retime.ts';
import { robustness } from './robustness.ts';
import { solve } from './solve.ts';
import { thumbnail } from './thumbnail.ts';

/** All jobs of a worker. */
export const JOBS: { readonly [K in JobKind]: Start<K> } = {
  solve,
  robustness,
  fan,
  difficulty,
  proofs,
  accuracy,
  check,
  fix,
  mend,
  thumbnail,
  generate,
  plays,
  lost,
  losses,
  retime,
  path,
};
