export { MendCard } from './MendCard.tsx';
export { MEND_KEY, type MendSession, mendSessionOf, watchMend } from './watch-mend.ts';
