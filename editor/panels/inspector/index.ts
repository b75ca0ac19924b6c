export { Inspector } from './Inspector.tsx';
export { nameOf } from './names.ts';
