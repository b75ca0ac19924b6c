import { ALL_EFFECTS } from '../effects/index.ts';
import { integratorOf } from '../integrators/index.ts';
import type { Method } from './method.ts';

/** The method for every scene and accuracy. */
export const WHOLE_METHOD: Method = { effects: ALL_EFFECTS, integratorOf };
