export { Minimap } from './Minimap.tsx';
