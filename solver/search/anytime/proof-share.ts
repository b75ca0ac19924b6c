/**
 * How much work a search for a proof may have done beside a search for a run: as much as that, and both together no more than the
 * effort.
 * @param search the work of the search for a run so far, ticks
 * @param effort the most work of both together, ticks; infinite for no limit
 * @returns ticks
 */
export const proofShare = (search: number, effort: number): number => Math.max(0, Math.min(search, effort - search));
