module jp_vuel_{id}
    use jp_runtime, only: dp
    use jp_element_{id}_smooth
    {use_rubbing}
    implicit none
    private
    public :: vuel_{id}
contains
    subroutine vuel_{id}(what, rhs, amass, dtimestable, svars, energy, &
            props, coords, mcrd, u, is_well)
        integer, intent(in) :: what, mcrd
        real(dp), intent(in) :: props(*), coords(mcrd, *), u({motions})
        real(dp), intent(inout) :: rhs({motions}), amass({motions}, {motions}), svars(*)
        real(dp), intent(inout) :: dtimestable, energy
        logical, intent(out) :: is_well
        {declarations}
        real(dp) :: mass({motions})
        integer :: code, k

        if (.not. keeps_order()) then
            error stop 'VUEL: compile with -fp-model precise'
        end if
        {masses}
        is_well = all(mass > 0) .and. all(mass <= huge(0.0_dp))
        if (.not. is_well) return
        ! 1: mass; 2: internal force and stable increment; 3: loads, which it does not have.
        if (what == 1) then
            amass = 0
            do k = 1, {motions}
                amass(k, k) = mass(k)
            end do
            return
        end if
        rhs = 0
        if (what /= 2) return
        {nodes}
        {call}
        is_well = code == 0
        {finite}
        if (.not. is_well) return
        rhs = -forces
        {conditions}
        {energy}
        ! 2 / omega: omega**2 is at most the norm of the stiffness between unit masses.
        mass = 1 / sqrt(mass)
        do k = 1, {motions}
            stiffness(:, k) = mass * stiffness(:, k) * mass(k)
        end do
        dtimestable = min(dtimestable, 2 / sqrt(max(norm2(stiffness), tiny(0.0_dp))))
    end subroutine vuel_{id}
{functions}end module jp_vuel_{id}
