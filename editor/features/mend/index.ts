export { MendCard } from './MendCard.tsx';
export { MEND_KEY, mendSessionOf, watchMend } from './watch-mend.ts';
