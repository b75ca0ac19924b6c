import { aliveOf } from '../alive/index.ts';
import type { Feature } from '../feature.ts';
import { MendCard } from './MendCard.tsx';
import { MEND_KEY, mendSessionOf, watchMend } from './watch-mend.ts';

/** What mends the level after a change that broke it. */
export const mend: Feature = {
  name: 'mend',
  offer: MendCard,
  commands({ open }) {
    /** What offers to mend the level; null if nothing does. */
    const offered = () => {
      const level = open.getState();
      const found = level === null ? null : mendSessionOf(level);
      return found === null || found.store.getState().phase === 'none' ? null : found;
    };
    const needsBroken = () => (open.getState() === null ? 'open a level first' : 'change something that breaks the level first');
    return [
      {
        id: 'level.mend',
        title: 'Mend what the last change broke',
        group: 'Solve',
        keys: [MEND_KEY],
        needs: () => (offered() === null ? needsBroken() : null),
        run: () => offered()?.start(),
      },
      {
        id: 'level.mend-dismiss',
        title: 'Leave broken what the last change broke',
        group: 'Solve',
        keys: ['Escape'],
        needs: () => (offered() === null ? 'nothing is offered to mend' : null),
        run: () => offered()?.leave(),
      },
    ];
  },
  open: ({ session, settings, desk }, level) => watchMend({ level, session, settings, desk, alive: aliveOf(level) }),
};
