// apart, so that a game without repulsors need not load what they do

export { repulsor } from './repulsor.ts';
