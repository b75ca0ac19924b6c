export { Rulers } from './Rulers.tsx';
