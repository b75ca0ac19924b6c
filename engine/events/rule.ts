import type { EventRule, Parts } from '../motion/index.ts';

/**
 * Makes a kind of event: an {@link EventRule} in which what is left out has a default. A set of effects sets its place in the
 * order.
 */
export function eventRule(rule: Pick<EventRule, 'name' | 'fire'> & Partial<Omit<EventRule, 'kind'>>): EventRule {
  // written out, so that all have the same hidden class and V8 finds properties fast
  return {
    name: rule.name,
    kind: 0,
    ends: rule.ends ?? null,
    passing: rule.passing ?? false,
    keepsPeriod: rule.keepsPeriod ?? false,
    list: rule.list ?? null,
    guard: rule.guard ?? null,
    isOver: rule.isOver ?? null,
    quiet: rule.quiet ?? null,
    first: rule.first ?? null,
    always: rule.always ?? null,
    alwaysQuiet: rule.alwaysQuiet ?? null,
    fire: rule.fire,
  };
}

/**
 * Lays out the kinds of events of the chosen effects.
 * @param all - every kind there is, in order
 * @param listedFirst - those with which the neighbour list begins, if they are chosen
 * @param chosen - those that can happen
 */
export function layOutRules(
  all: readonly EventRule[],
  listedFirst: readonly EventRule[],
  chosen: readonly EventRule[],
): Pick<Parts, 'byKind' | 'list' | 'first' | 'always' | 'alwaysQuiet'> {
  const used = all.filter((rule) => chosen.includes(rule));
  const byKind: EventRule[] = [];
  for (const rule of all) byKind[rule.kind] = rule;
  return {
    byKind,
    list: [...new Set([...listedFirst, ...all])].filter((rule) => used.includes(rule) && rule.list !== null),
    first: used.filter((rule) => rule.first !== null),
    always: used.filter((rule) => rule.always !== null),
    alwaysQuiet: used.filter((rule) => rule.alwaysQuiet !== null),
  };
}
