import type { Finding, Problem } from '../../basics/problem.ts';
import type { Locator } from '../../json/locate.ts';

/** A map as a value in Tiled's JSON map format, whatever the format of the file. */
export type MapSource =
  | {
      readonly ok: true;
      readonly text: string;
      readonly value: unknown;
      readonly locator: Locator;
      readonly findings: readonly Finding[];
    }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };
