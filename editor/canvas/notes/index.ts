export { NotePins } from './NotePins.tsx';
