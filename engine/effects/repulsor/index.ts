// apart, so that a game without repulsors need not load what they do
export { letGoTime } from './let-go.ts';
export { repulsor } from './repulsor.ts';
