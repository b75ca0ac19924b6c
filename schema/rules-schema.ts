import * as z from 'zod';
import { RULE_NAMES, type RuleName } from './default-rules.ts';
import { type GameRule, RULES } from './rules.ts';

const number = (rule: GameRule) =>
  z.number().min(rule.least).max(rule.most).optional().describe(`${rule.about} In ${rule.unit}; ${rule.default} when left out.`);

/** The zod schema of `rules` in a level file or in the configuration of a folder. */
export const rulesSchema = z
  .strictObject(
    Object.fromEntries(RULE_NAMES.map((name) => [name, number(RULES[name])])) as {
      [name in RuleName]: z.ZodOptional<z.ZodNumber>;
    },
  )
  .describe('Numbers of the game that are another here; the game’s own when left out.');
