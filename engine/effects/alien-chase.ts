import { whereAny } from './count.ts';
import type { Effect } from './effect.ts';
export const alienChase: Effect = {
  name: 'alien-chase',
  summary: 'an alien within 150 px accelerates towards her at 8 px/s2, otherwise it stops dead; touching it ends the run',
  calledFor: whereAny('aliens', 'alien'),
};
