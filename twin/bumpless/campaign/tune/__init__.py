"""Search parameters over drawn missions: outcome first, then tracking, smoothness and cost."""
